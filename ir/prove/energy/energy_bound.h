// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/energy/energy_use.h"

#include <optional>
#include <vector>

/// Upper bounds of the energy that a mission takes from the batteries, from the vehicle's power
/// table (docs/power.md has what they assume), without a solver.
namespace glider::ir::prove {

/// Of a state, while it is current.
struct StateBound {
  StateId state;
  double watts = 0;       ///< on average, for long
  bool restless = false;  ///< how often it turns is not known: its pump hardly rests
};

struct EnergyBound {
  /// Until the mission ends, J; none: it is not known when it does.
  std::optional<double> joules;
  double watts = 0;      ///< on average, for long
  double deepest_m = 0;  ///< the vehicle goes no deeper
  double start_j = 0;    ///< the mission takes no more than this and `watts` times its time
  std::vector<DeviceEnergy> devices;  ///< of a second for long, or of `joules`: the greatest first
  std::vector<StateBound> states;     ///< those that may become current
  /// The states that take the most by following one another soon, again and again, if that is much
  /// more than any of them takes for long; and the time of one round, s.
  std::vector<StateId> round;
  double round_s = 0;
  /// An exit without a power cut comes no earlier, s, and the mission has then taken no less, J;
  /// none: it has no exit.
  std::optional<double> earliest_s;
  double least_j = 0;
};

/// Which values the parameters of the mission have.
enum class Parameters : uint8_t { AsWritten, Any };

/// None for a vehicle whose file says too
/// little for it, and for a mission with more transitions than are worth following. `board`: what
/// the SBC draws.
std::optional<EnergyBound> energyBoundOf(const Mission& mission,
                                         const platforms::Platform& platform,
                                         const std::optional<platforms::BoardPower>& board,
                                         Parameters parameters);

}  // namespace glider::ir::prove
