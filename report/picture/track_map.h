// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "report/picture/legend.h"
#include "report/picture/page.h"
#include "support/trace/trace.h"

namespace glider::report::picture {

/// Whether the way over ground deserves a map: the flight has a track, and did not just go straight
/// on or drift about one place.
bool deservesMap(const support::Trace& trace);

/// Draws the track from above into `box`, coloured by state, with equal scales, and with it the
/// vehicle's dead-reckoned track and the waypoints. Returns the meaning of its lines and marks.
std::vector<LegendEntry> drawMap(SvgText& svg, const support::Trace& trace, const Box& box);

}  // namespace glider::report::picture
