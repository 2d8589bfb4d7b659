// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/trace/submersions.h"

#include <cmath>

namespace glider::support {

std::vector<Submersion> submersions(const Trace& trace) {
  constexpr double kWave = 1, kStay = 120;  // m, s
  const int measured = trace.column("m_depth");
  const int depth = measured >= 0 ? measured : trace.column("true_depth");
  std::vector<Submersion> found;
  std::optional<size_t> begin;
  bool dived = false;
  // Ends the submersion, unless the last one has ended just before it: then it is the same.
  const auto end = [&](std::optional<size_t> row) {
    if (!found.empty() && trace.at(*begin, 0) - trace.at(*found.back().end, 0) < kStay) {
      found.back().end = row;
    } else {
      found.push_back({*begin, row});
    }
  };
  for (size_t row = 0; depth >= 0 && row < trace.rowCount(); ++row) {
    const double here = trace.at(row, depth);
    if (std::isnan(here)) {
      continue;
    }
    if (here > kSurfaceDepth) {
      begin = begin ? begin : row;
      dived = dived || here > kSurfaceDepth + kWave;
      continue;
    }
    if (begin && dived) {
      end(row);
    }
    begin.reset();
    dived = false;
  }
  if (begin && dived) {
    end(std::nullopt);
  }
  return found;
}

}  // namespace glider::support
