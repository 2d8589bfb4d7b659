// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <vector>

namespace glider::report::picture {

/// A point, in pixels of the page or in the units of a chart.
struct Dot {
  double x = 0;
  double y = 0;
};
using Line = std::vector<Dot>;

/// `line` without the points that are within `tolerance` of the remaining line (Douglas and Peucker
/// 1973). The ends are kept.
Line simplified(const Line& line, double tolerance);

/// The greatest error of a line on the page, px: less than can be seen.
inline constexpr double kUnseen = 1.0 / 3;

/// The value of the attribute d of a path: `line` to a tenth of a pixel, each step relative to the
/// point before, so that a long track stays a small text. Empty for fewer than two points.
std::string pathData(const Line& line);

}  // namespace glider::report::picture
