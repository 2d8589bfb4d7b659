// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/abstract/abstract_evaluator.h"

#include <vector>

namespace glider::ir::prove {

/// When a state's own cases fire at the latest, by the clocks; mission times, s.
struct Leaving {
  double by =
      0;  ///< some case, of its own or of `always`, has led away; infinite: nothing makes it go
  /// Of each case: no tick after it lets the case fire, for one before it has led away for sure.
  std::vector<double> latest;
  size_t looks = 0;  ///< how many moments were looked at
};

/// A list of cases, or what of it may fire.
using Cases = std::vector<const Case*>;

/// The cases of `always` that may interrupt a state.
struct Interruptions {
  Cases cases;
  bool own_first = false;  ///< on its first tick the state's own come before
};

/// Of `state`, if it became current at `since` at the latest and its variables are within `values`
/// all the while, whatever the sensors say.
Leaving leavingOf(const ProofContext& proof_context, const State& state,
                  const Interruptions& always, const Valuation& values, double since);

}  // namespace glider::ir::prove
