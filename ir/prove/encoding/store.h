// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/encoding/symbolic_state.h"

#include <map>
#include <optional>

namespace glider::ir::prove {

/// The vehicle as commands affect it (ir/prove/encoding/world.h says how it moves).
struct Vehicle {
  z3::expr depth;     ///< true depth, m
  z3::expr deepest;   ///< upper bound of its depth under the command in force, m
  z3::expr climbing;  ///< the command in force leads up
  z3::expr since;  ///< mission time of the first command to climb that has been in force since, s
  z3::expr top;    ///< of the command in force, if it leads up, m
};

/// What a mission keeps from tick to tick, as terms: its variables, and the vehicle if it is in the
/// cone of influence.
struct Store {
  std::map<uint32_t, NumberTerm> numbers;  ///< by variable; without slack
  std::map<uint32_t, TruthTerm> truths;
  std::optional<Vehicle> vehicle;

  /// Gives `moment` the values of these variables.
  void show(SymbolicState& moment) const;
};

/// `yes` where `condition` holds, otherwise `no`; both have the same variables.
Store choose(const z3::expr& condition, const Store& yes, const Store& no);

}  // namespace glider::ir::prove
