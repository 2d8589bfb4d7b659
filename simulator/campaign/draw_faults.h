// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"
#include "simulator/campaign/promises.h"
#include "simulator/faults/faults.h"
#include "simulator/scenario/scenario.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace glider::simulator {

/// When faults of a kind occur.
enum class Manner : uint8_t {
  Once,       ///< at any time; one in eight of those that may last does not end
  Recurring,  ///< three to six times
  Together,   ///< with faults of another kind at the same time
  Handshake,  ///< while control is taken
  Exit,       ///< while it is released
  ForGood,    ///< from a random time on, without an end
};
inline constexpr uint32_t kManners = 6;
/// "in the handshake".
const char* nameOf(Manner manner);

/// A mission's flight without a fault.
struct FlightTimes {
  double flight_s = 0;
  double take_s = 0;     ///< when control is taken
  double release_s = 0;  ///< when it is released
  double deepest_m = 20;
  Span hover = {0, 0};  ///< its longest
};

/// How the vehicle differs from the one of the scenario. None of this is a fault: such vehicles
/// fly.
struct DrawnVehicle {
  bool no_ctd = false;
  double altimeter_range_m = 0;  ///< 0: the scenario's
  double altimeter_dropout = 0;  ///< with a range
  double pressure_every_s = 0;   ///< c_pressure_time; 0: the mission file's
  [[nodiscard]] bool differs() const {
    return no_ctd || altimeter_range_m > 0 || pressure_every_s > 0;
  }
};

/// Arguments of what carries out the commands, drawn instead of those of the vehicle's own mission.
struct DrawnArgs {
  double start_secs = 0, max_depth_m = 0, min_altitude_m = 0, max_pitch_rad = 0, hold_secs = 0;
  double dive_pump_cc = -230, climb_pump_cc = 230;
};

/// The faults drawn for a flight.
struct DrawnFaults {
  std::vector<FaultKind> kinds;
  Faults faults;
  std::optional<DrawnArgs> args;
  std::optional<double> water_depth_m;
  DrawnVehicle vehicle;

  /// True if a sensor is wrong, or the environment or the mission file is changed: the mission may
  /// then take its longest path to the exit, or never reach it.
  [[nodiscard]] bool lasts() const;
  /// Applies them to the scenario of a flight, and to the vehicle's own mission in it.
  void applyTo(const platforms::Platform& platform, Scenario& scenario) const;
};

/// Draws faults of kind `kind` within a flight. The same seed draws the same.
DrawnFaults drawFaults(FaultKind kind, Manner manner, uint64_t seed, const FlightTimes& times);

}  // namespace glider::simulator
