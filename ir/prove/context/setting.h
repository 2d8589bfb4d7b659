// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <vector>

namespace glider::ir::prove {

/// For every `became` and `held`: the variables that its operand or its duration reads and that a
/// list tried before its own may set in the same tick. Temporals are evaluated before any list is
/// tried, so a guard of the list may read another value than the temporal did.
std::vector<std::vector<VariableId>> setSinceWatched(const Mission& mission);

/// For every variable, whether it may be set between two commands of the state's profile while the
/// state is not entered between them. This includes all that may happen in between, such as a state
/// that it calls.
std::vector<bool> setWhileCurrent(const Mission& mission, const State& state);

}  // namespace glider::ir::prove
