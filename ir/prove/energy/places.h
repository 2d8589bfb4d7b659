// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/abstract/abstract_evaluator.h"
#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/abstract/leaving.h"

#include <cstddef>
#include <deque>
#include <vector>

namespace glider::ir::prove {

/// A case that leads out of a place, and where it may lead; nowhere if it ends the mission.
struct StayStep {
  const Case* by = nullptr;
  ListKind list = ListKind::State;  ///< of the case, or always
  size_t number = 0;                ///< in its list
  std::vector<size_t> to;
};

/// Where a mission may be: a state in a call configuration with some values of its variables, or
/// any of them.
struct StayPlace {
  uint32_t state = 0;
  bool again = false;  ///< it has become current by `return`
  const Valuation* values = nullptr;
  Cases always;  ///< those of `always` that certainly interrupt it where they are true
  std::vector<StayStep> steps;
};

/// Every trace goes from place to place by these steps.
struct StayPlaces {
  std::vector<StayPlace> all;
  size_t first = 0;
  std::deque<Valuation> values;  ///< of the places
};

/// By the stays of the mission (staysOf) if its end is bounded; otherwise each state as it is
/// entered and as it is resumed, by any `return` if anything is called from it.
StayPlaces placesOf(const ProofContext& proof_context);

}  // namespace glider::ir::prove
