// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

namespace glider::ir {

/// What an expression reads, itself or in its operands.
struct Reads {
  StateId state;               ///< whose variables or temporals; invalid: no state's
  bool two_states = false;     ///< of more than one state: it has a meaning nowhere
  uint32_t variables_end = 0;  ///< one more than the greatest number of a variable
  uint32_t temporals_end = 0;  ///< the same of a temporal
  bool moment = false;         ///< a sensor, a clock or a C function
  bool mission = false;        ///< a variable of the mission that is no parameter
};

/// Of an expression whose operands read what stands in `operands` at their numbers.
Reads readsOf(const Mission& mission, const Expr& expr, const std::vector<Reads>& operands);

/// Of every expression of `mission`, whose expressions must be sound.
std::vector<Reads> readsOf(const Mission& mission);

}  // namespace glider::ir
