// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "ir/prove/prove.h"
#include "support/result.h"

#include <cstdint>
#include <optional>
#include <string>

namespace glider::analysis {

/// A simulated flight that violates a requirement.
struct BreakingFlight {
  std::string scenario;
  uint64_t seed = 0;
  double when = 0;  ///< mission time, s
};

/// The result of the search for such a flight.
struct ClosedLoop {
  size_t flights = 0;  ///< flights that were flown
  std::optional<BreakingFlight> breaking;
};

/// Looks for a flight that violates the refuted requirement of `verdict`: flies each scenario that
/// comes with glidercc, with a few seeds and the parameters of the counterexample, until a flight
/// violates it. The compiled mission flies in this process. What it receives is passed to the
/// interpreter, whose result is checked as for a replay. No flight if the mission needs code in C
/// or is for a vehicle that the simulator cannot fly. Fails as compiling and simulating do.
support::Result<ClosedLoop> searchClosedLoop(const compiler::Optimised& mission,
                                             const ir::prove::RequirementVerdict& verdict);

}  // namespace glider::analysis
