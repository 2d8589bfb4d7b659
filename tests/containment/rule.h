// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "tests/containment/flight.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <span>

namespace glider::containment {

/// What the prover says about one mission, compared with flights of it.
class Rule {
 public:
  virtual ~Rule() = default;
  /// After the start.
  virtual void start(const Flight& flight) { tick(flight); }
  /// In the middle of a tick: readings and temporals are those of the tick, nothing has fired.
  virtual void begun(const Flight&) {}
  virtual void tick(const Flight& flight) = 0;
  /// The number of claims that were compared with what the flight did.
  size_t steps = 0;
};

/// None if the rule says nothing about this mission.
using MakeRule = std::function<std::unique_ptr<Rule>(const ir::prove::ProofContext&)>;

struct Plan {
  size_t flights = 3;  ///< of each mission
  size_t ticks = 80;
  bool power_cuts = true;
  double share = 1;  ///< of the steps, for a rule of which each takes long
};

/// Flies missions until the rule has been compared with GLIDER_CONTAINMENT steps (5000), or fails;
/// seeds from GLIDER_CONTAINMENT_SEED (0) on.
void holdsFor(const MakeRule& make, const Plan& plan = {});

/// The same for one flight of each of these missions.
void holdsOn(std::span<const ir::Mission> missions, const MakeRule& make, const Plan& plan);

/// The same for a class that is made from the context.
template <typename R>
void holds(const Plan& plan = {}) {
  holdsFor([](const ir::prove::ProofContext& context) { return std::make_unique<R>(context); },
           plan);
}

}  // namespace glider::containment
