// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/verify/intervals.h"

#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace glider::ir {

/// A statement by its block and its place in it, or an argument by its case and its place.
using AssignmentPlace = std::pair<const void*, size_t>;

/// The assignments in `doubtful` (statements `set`: block and number; arguments: case and number)
/// that the guards before them keep in the range of their variable: `case n < 10 do set n = n + 1
/// end`. `intervals`: of every expression, regardless of guards.
///
/// On the tick on which a block runs, its guard was true and the earlier cases of its list were
/// not. Readings, clocks, windows and the results of C functions stay the same until the tick's
/// transition, variables until the block sets them. The condition of an `if` holds in its branches;
/// an unknown one takes neither. What is watched over time gives no knowledge: it was evaluated
/// before other lists ran.
std::set<AssignmentPlace> keptByGuards(const Mission& mission,
                                       const std::vector<Interval>& intervals,
                                       const std::set<AssignmentPlace>& doubtful);

/// An argument of a command: by its statement and its place.
using CommandArgument = std::pair<const Statement*, size_t>;

/// The ranges of the arguments of all commands, as the same guards keep them; without those of
/// commands that no guard lets through. `intervals`: as above.
std::map<CommandArgument, Interval> commandRanges(const Mission& mission,
                                                  const std::vector<Interval>& intervals);

}  // namespace glider::ir
