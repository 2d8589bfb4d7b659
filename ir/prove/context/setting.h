// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <vector>

namespace glider::ir::prove {

/// Of every `became` and `held`: the variables that its operand or its duration reads and that a
/// list tried before its own may set in the same tick. Temporals are judged before any list is
/// tried, so a guard of the list may find another value than the temporal did.
std::vector<std::vector<VariableId>> setSinceWatched(const Mission& mission);

/// Of every variable, whether something may set it between two commands of the state's profile with
/// no entering of the state between them: whatever else has come about, a state that it calls
/// included.
std::vector<bool> setWhileCurrent(const Mission& mission, const State& state);

}  // namespace glider::ir::prove
