// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/verify/intervals.h"

#include <vector>

namespace glider::ir::prove {

/// For every expression, its range in any trace when it is known. As intervalsOf, but the range of
/// a variable is that of its initial value, its arguments and the values that it is set to. This is
/// often smaller than its declared range, and also bounds some variables without one.
std::vector<Interval> heldIntervals(const Mission& mission);
/// The same for every variable; empty for one that nothing sets.
std::vector<Interval> heldVariables(const Mission& mission);

}  // namespace glider::ir::prove
