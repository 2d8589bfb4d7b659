// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/verify/intervals.h"

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace glider::ir {

/// A statement by its block and its place in it, or an argument by its case and its place.
using AssignmentPlace = std::pair<const void*, size_t>;

/// Of the assignments in `doubtful` (statements `set`: block and number; arguments: case and
/// number), those that the guards before them keep in the range of their variable: `case n < 10 do
/// set n = n + 1 end`. `intervals`: of every expression, whatever guards say.
///
/// A guard was true, and an earlier case of its list not true, on the tick on which a block runs;
/// readings, clocks, windows and what C functions gave stay the same until the tick's transition,
/// variables until the block sets them. An `if` holds for its branches, and an unknown one takes
/// neither. What is watched over time says nothing: it was judged before other lists ran.
std::set<AssignmentPlace> keptByGuards(const Mission& mission,
                                       const std::vector<Interval>& intervals,
                                       const std::set<AssignmentPlace>& doubtful);

}  // namespace glider::ir
