// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/acoustics/trouble.h"
#include "simulator/faults/faults.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace glider::campaign {

/// What goes wrong between the vehicles of a fleet.
enum class FleetFault : uint8_t {
  None,
  Loss,     ///< some of the messages are lost, at random
  Silence,  ///< all of them are
  Noise,    ///< noise in the water, at times, hides what arrives at some vehicles
  Liar,     ///< one vehicle sends other things than the truth
  Several,  ///< the last three but silence together
};
inline constexpr uint32_t kFleetFaults = 6;
/// As in the table: "loss".
const char* nameOf(FleetFault fault);

/// A vehicle that lies.
struct FleetLiar {
  size_t vehicle = 0;  ///< of those that talk
  simulator::Lie lie = simulator::Lie::Values;
};

/// What was drawn for a flight.
struct FleetTrouble {
  double loss = 0;                                  ///< as simulator::AcousticTrouble
  std::vector<std::vector<simulator::Span>> noise;  ///< of each vehicle
  std::optional<FleetLiar> liar;
};

/// Draws for a flight of `vehicles` that takes about `flight_s`. The same seed draws the same.
FleetTrouble drawTrouble(FleetFault fault, uint64_t seed, size_t vehicles, double flight_s);

/// A line for each thing that was drawn; `names` are those of the vehicles.
std::string describe(const FleetTrouble& trouble, const std::vector<std::string>& names);

}  // namespace glider::campaign
