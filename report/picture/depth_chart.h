// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "report/picture/colouring.h"
#include "report/picture/legend.h"
#include "report/picture/page.h"

#include <vector>

namespace glider::report::picture {

/// Draws depth against time into `box`, with a band of `kBand` above that says who decides and the
/// numbers and titles of the axes outside of it. Returns what its lines and areas are.
std::vector<LegendEntry> drawDepthChart(SvgText& svg, const support::Trace& trace,
                                        const Colouring& colouring, const Box& box);

/// Room that the band above the chart needs, px.
inline constexpr double kBand = 26;

/// The scale of colours along the right of `box`; needs `kScaleRoom` there.
void drawScale(SvgText& svg, const Colouring& colouring, const Box& box);
inline constexpr double kScaleRoom = 84;

}  // namespace glider::report::picture
