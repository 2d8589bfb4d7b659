// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/output/track_colour.h"

#include "driver/terminal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace glider::driver {
namespace {

bool hasReadings(const support::Trace& trace, std::string_view name) {
  const int column = trace.column(std::string(name));
  for (size_t row = 0; column >= 0 && row < trace.rowCount(); ++row) {
    if (std::isfinite(trace.at(row, column))) {
      return true;
    }
  }
  return false;
}

}  // namespace

report::PictureStyle styleFor(const support::Trace& trace, const report::PictureStyle& style) {
  const bool drawn = !style.colour || *style.colour == "state" ||
                     std::ranges::any_of(report::pictureQuantities(), [&](const auto& quantity) {
                       return quantity.name == *style.colour && hasReadings(trace, quantity.column);
                     });
  if (drawn) {
    return style;
  }
  tell(
      fmt::format("glidercc: note: the flight has no reading of `{}`, so the picture is coloured "
                  "as without `--colour-by`\n",
                  *style.colour));
  report::PictureStyle usual = style;
  usual.colour.reset();
  return usual;
}

}  // namespace glider::driver
