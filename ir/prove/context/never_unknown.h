// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/verify/inherited.h"
#include "ir/verify/intervals.h"

#include <vector>

namespace glider::ir::prove {

/// Which variables are known whenever they have started, because their initial value, or each
/// argument that they are given, is known for any readings of the sensors; and which expressions
/// are then known. (`set` never makes a variable unknown.) `intervals`: the range of every
/// expression when it is known.
GreatestFixpoint neverUnknown(const Mission& mission, const std::vector<Interval>& intervals);

/// Which expressions are known at a moment at which these are also known; `always` is the result of
/// neverUnknown.
std::vector<bool> knownWhere(const Mission& mission, const std::vector<Interval>& intervals,
                             const GreatestFixpoint& always, const std::vector<ExprId>& shown);

}  // namespace glider::ir::prove
