// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "report/picture/polyline.h"
#include "support/trace/trace.h"

namespace glider::report::picture {

/// The lines on which `field` is `level`, each a line in s and m, interpolated between the points
/// of its grid (marching squares). Cells with an unknown corner have no line.
std::vector<Line> contours(const support::TraceField& field, double level);

}  // namespace glider::report::picture
