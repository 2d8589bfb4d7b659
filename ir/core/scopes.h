// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

namespace glider::ir {

/// What an expression reads, itself or through its operands.
struct Reads {
  StateId state;            ///< whose variables or temporals; invalid: no state's
  bool two_states = false;  ///< of more than one state: such an expression has no meaning anywhere
  uint32_t variables_end = 0;  ///< one more than the greatest number of a variable
  uint32_t temporals_end = 0;  ///< the same of a temporal
  bool moment = false;         ///< a sensor, a clock or a C function
  bool mission = false;        ///< a variable of the mission that is not a parameter
  bool monitor = false;        ///< a variable of a requirement's monitor
};

/// What an expression reads, given what its operands read: `operands` has an entry for each
/// expression number.
Reads readsOf(const Mission& mission, const Expr& expr, const std::vector<Reads>& operands);

/// The same for every expression of `mission`, whose expressions must be valid.
std::vector<Reads> readsOf(const Mission& mission);

}  // namespace glider::ir
