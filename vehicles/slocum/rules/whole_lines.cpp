// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/context/duration_text.h"
#include "support/diagnostics/ids/verification.h"
#include "vehicles/slocum/rules/whole.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace glider::slocum::rules {
namespace {

std::string sumOf(const Ending& ending) {
  std::vector<std::string> parts;
  for (const Part& part : ending.parts) {
    parts.push_back(fmt::format("{} {:.0f} s", part.what, part.seconds));
  }
  return fmt::format("{}", fmt::join(parts, " + "));
}

}  // namespace

void reportEndings(const Whole& whole, support::DiagnosticEngine& diagnostics) {
  for (const Ending& ending : whole.alike()) {
    if (!ending.proved()) {
      diagnostics.report(support::diagnostics::mayStayBelow, ending.range, ending.after,
                         ending.why_not, ending.change);
    }
  }
}

std::vector<std::string> wholeLines(const Whole& whole) {
  std::vector<std::string> lines;
  for (const Ending& ending : whole.alike()) {
    if (ending.proved()) {
      lines.push_back(fmt::format("after {} the vehicle is at the surface within {}, by {}: {}",
                                  ending.after, ir::prove::durationOf(ending.seconds()), ending.by,
                                  sumOf(ending)));
    }
  }
  return lines;
}

}  // namespace glider::slocum::rules
