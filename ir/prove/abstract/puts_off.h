// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/abstract/abstract_evaluator.h"
#include "ir/prove/context/control.h"

namespace glider::ir::prove {

/// Finds where a state that has just been resumed may put `always` off: on its next tick its own
/// cases come first.
class PutsOff {
 public:
  /// `proof_context` outlives this.
  explicit PutsOff(const ProofContext& proof_context);

  /// The first own case of the state that may fire on the first tick after it is resumed, by its
  /// clocks; null: none may.
  [[nodiscard]] const Case* by(StateId state) const;
  [[nodiscard]] bool at(const Control& control) const {
    return control.just_returned && by(control.state) != nullptr;
  }
  /// By a return.
  [[nodiscard]] bool again(const Control& control) const;

 private:
  [[nodiscard]] bool mayFire(const Case& c) const { return next_tick_.truth(c.guard).is_true; }

  const Mission& mission_;
  Valuation values_;
  AbstractEvaluator next_tick_;
};

}  // namespace glider::ir::prove
