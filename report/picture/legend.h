// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "report/picture/page.h"

#include <string>
#include <vector>

namespace glider::report::picture {

/// One entry: how something is drawn, and its meaning.
struct LegendEntry {
  std::string classes;  ///< of the sample's shape
  std::string colour;   ///< fills it; empty for a line
  std::string text;
};

/// The mark of a waypoint.
void drawDiamond(SvgText& svg, Dot middle);

/// The entries in lines of at most `width`, from `at` on; returns the height.
double drawLegend(SvgText& svg, const std::vector<LegendEntry>& entries, Dot at, double width);

}  // namespace glider::report::picture
