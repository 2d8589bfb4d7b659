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

/// A flight of the simulator that breaks a requirement.
struct BreakingFlight {
  std::string scenario;
  uint64_t seed = 0;
  double when = 0;  ///< mission time, s
};

/// What came of the search for one.
struct ClosedLoop {
  size_t flights = 0;  ///< that were flown
  std::optional<BreakingFlight> breaking;
};

/// Looks for a flight that breaks what `verdict` says is refuted: in each scenario that comes with
/// glidercc, with a few seeds and the parameters of the run that was found, until one does. The
/// compiled mission flies in this process; what it hears is given to the interpreter, which is
/// judged as a replay is. No flight, if the mission needs code in C or is for
/// a vehicle that the simulator cannot fly. Fails as compiling and
/// simulating do.
support::Result<ClosedLoop> searchClosedLoop(const compiler::Optimised& mission,
                                             const ir::prove::RequirementVerdict& verdict);

}  // namespace glider::analysis
