// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/verify/intervals.h"

#include <vector>

namespace glider::ir {

/// For every expression of `mission`, whether it is a whole number below 2^53 whenever it is known:
/// doubles add, subtract and multiply such numbers without rounding. `intervals`: of every
/// expression.
std::vector<bool> wholeExpressions(const Mission& mission, const std::vector<Interval>& intervals);

}  // namespace glider::ir
