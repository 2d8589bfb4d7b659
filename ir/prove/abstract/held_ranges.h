// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/verify/intervals.h"

#include <vector>

namespace glider::ir::prove {

/// Of every expression, where it lies in any run when it is known. As intervalsOf, but a variable
/// lies where its initial value, its arguments and what it is set to lie, which is often less than
/// its range, and something for a variable without one.
std::vector<Interval> heldIntervals(const Mission& mission);

}  // namespace glider::ir::prove
