// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/values.h"
#include "simulator/slocum/flight/science_switches.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace glider::simulator {

/// What a behaviour commands to the slot of the heading.
struct HeadingCommand {
  /// Ignore: the slot is busy, and the fin stays where it is.
  enum class Mode : uint8_t { Waypoint, Heading, Fin, Ignore } mode = Mode::Fin;
  double value_rad = 0;  ///< heading or fin
  double latitude_ddmm = 0, longitude_ddmm = 0;
};

/// What a behaviour commands to the slot of the pitch.
struct PitchCommand {
  /// At a battery position (in); once from the calibration curve (rad); held by the servo (rad);
  /// Ignore: the slot is busy, and the battery stays where it is.
  enum class Mode : uint8_t { BatteryPosition, Curve, Servo, Ignore } mode = Mode::Servo;
  double value = 0;
  bool operator==(const PitchCommand&) const = default;
};

/// Why a mission is aborted: `x_mission_status`.
enum class Abort : int8_t {
  None = 0,
  StackIdle = 1,
  HeadingIdle = 2,
  PitchIdle = 3,
  PumpIdle = 4,
  Overdepth = 7,
  Overtime = 8,
  Undervolts = 9,
  SameDepth = 10,
  NoTickle = 14,
  DeviceError = 16,
  WaypointTooFar = 18,
  OutOfBand = 63,  ///< no status of the vehicle: its computer resets
};
/// "MS_ABORT_OVERDEPTH".
const char* abortName(Abort abort);

constexpr int kNoLayer = -1;

/// The command record of one cycle: one slot per channel, and which behaviour (by its place in the
/// mission file, from 0) filled it. Behaviours run from the lowest priority up, and later runners
/// overwrite.
struct Commands {
  std::optional<HeadingCommand> heading;
  std::optional<PitchCommand> pitch;
  std::optional<double> pump_cc;  ///< NaN: the slot is busy, and the pump stays where it is
  int heading_layer = kNoLayer, pitch_layer = kNoLayer, pump_layer = kNoLayer;

  bool hit_waypoint = false;  ///< a list of waypoints has reached one in this cycle
  bool hovering = false;      ///< drift_at_depth holds its depth
  bool at_once = false;       ///< an abort: no inflection may delay it
  bool altimeter = false;     ///< a leg with a target altitude needs it, also if it is switched off

  std::vector<SampleOrder> samples;  ///< of the behaviours sample
  uint32_t sampling = 0;  ///< what the SBC orders instead of them (hooks/protocol/sampling.h)

  /// `layer` of what is commanded from now on.
  int layer = kNoLayer;
  void steer(HeadingCommand command) { heading = command, heading_layer = layer; }
  void point(PitchCommand command) { pitch = command, pitch_layer = layer; }
  void pump(double cc) { pump_cc = cc, pump_layer = layer; }

  /// The slots that `of_layer` did not fill last, as hooks::kMaskedHeading….
  [[nodiscard]] uint8_t maskedFor(int of_layer) const;
  [[nodiscard]] bool anyIdle() const { return !heading || !pitch || !pump_cc; }
  /// The abort that idle slots call for.
  [[nodiscard]] Abort idleAbort() const;
};

}  // namespace glider::simulator
