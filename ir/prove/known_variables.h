// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/verify/intervals.h"

#include <vector>

namespace glider::ir::prove {

/// Of each variable, whether it is known whenever it has started: its initial value, or each
/// argument that it is given, is known whatever the sensors say. (`set` never makes a variable
/// unknown.) `intervals` are intervalsOf(mission).
std::vector<bool> knownVariables(const Mission& mission, const std::vector<Interval>& intervals);

}  // namespace glider::ir::prove
