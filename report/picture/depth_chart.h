// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "report/picture/axis.h"
#include "report/picture/colouring.h"
#include "report/picture/legend.h"
#include "report/picture/page.h"

#include <vector>

namespace glider::report::picture {

/// Draws depth against time into `box`. Above it is a band of `kBand` that shows what controls the
/// vehicle; the numbers and titles of the axes are outside. Returns the meaning of its lines and
/// areas.
std::vector<LegendEntry> drawDepthChart(SvgText& svg, const support::Trace& trace,
                                        const Colouring& colouring, const Box& box);

/// The scale of the depths of that chart in `box`.
Axis depthAxis(const support::Trace& trace, const Box& box);

/// The height of the band above the chart, px.
inline constexpr double kBand = 26;

/// Draws the scale of colours along the right of `box`; needs `kScaleRoom` there.
void drawScale(SvgText& svg, const Colouring& colouring, const Box& box);
inline constexpr double kScaleRoom = 84;

}  // namespace glider::report::picture
