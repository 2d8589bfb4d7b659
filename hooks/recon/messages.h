// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/text.h"

#include <stdint.h>

/// The messages of RECON (README.md), in its own units: angles in degrees, lengths in m. Text
/// points into the line that was read, or stays where it is until it is written. No heap.
namespace glider::hooks::recon {

/// A number that the vehicle does not know.
inline constexpr double kUnknown = __builtin_nan("");

using hooks::Text;
using hooks::textOf;

// From the SBC to the vehicle. The vehicle sends the last command back as it was.

/// #C,Heading,Goal
struct HeadingGoal {
  double heading_deg = 0;  ///< clockwise from true north
};

enum class SpeedUnit : uint8_t { MetresPerSecond, Rpm };

/// #C,Speed
struct SpeedGoal {
  double value = 0;
  SpeedUnit unit = SpeedUnit::MetresPerSecond;
};

/// #C,Depth,Depth
struct DepthGoal {
  double depth_m = 0;
};

/// #C,Depth,Triangle: between a depth and an altitude. The unit of its rate is not known.
struct TriangleGoal {
  double depth_m = 0;
  double altitude_m = 0;
  double rate = 0;
  double greatest_depth_m = 0;
};

/// #E: asks for control (the override of the vehicle's own mission), or releases it.
struct Override {
  bool on = false;
};

/// #V: the SBC is there and does not want control.
struct KeepAlive {};

/// #s,Time,query
struct TimeQuery {};

/// #m 1,1: a text for the acoustic modem.
struct ModemText {
  Text text;
};

// From the vehicle to the SBC.

/// What the mode byte of a state says. With kNotDeployed set, the rest has no meaning here. 0x02
/// and 0x0E occur too, launched without and with the override: the driver in README.md changes
/// nothing when it reads them.
inline constexpr uint8_t kNotDeployed = 0x10;
struct Mode {
  enum : uint8_t {
    Launched = 0x01,  ///< the vehicle flies its own mission
    Over = 0x03,      ///< its mission has ended
    Override = 0x0D,  ///< it obeys the SBC, or asks it to take control
  };
};

/// #S. Each number may be kUnknown.
struct State {
  double time_s = kUnknown;  ///< since midnight, UTC; a state has no date
  double latitude_deg = kUnknown;
  double longitude_deg = kUnknown;
  double depth_m = kUnknown;
  double depth_goal_m = kUnknown;
  double altitude_m = kUnknown;  ///< 0 on the line: unknown
  double pitch_deg = kUnknown;
  double roll_deg = kUnknown;
  double rpm = kUnknown;
  double rpm_goal = kUnknown;
  double speed_m_s = kUnknown;
  double heading_deg = kUnknown;
  double heading_rate_deg_s = kUnknown;
  double heading_goal_deg = kUnknown;
  uint8_t mode = 0;
  double leg = kUnknown;  ///< of the vehicle's own mission
};

/// #s,TIME: the answer to a TimeQuery.
struct TimeSet {
  double unix_s = 0;  ///< since 1970, UTC
};

/// #s,SHUTDOWN: the power of the SBC goes off soon.
struct Shutdown {};

/// #c. Each number may be kUnknown.
struct Ctd {
  double temperature_degC = kUnknown;
  double conductivity = kUnknown;  ///< its unit is not known
  double salinity = kUnknown;
  double depth_m = kUnknown;
  double sound_speed_m_s = kUnknown;
};

/// #m,MSG_DATA: a text that came by the acoustic modem. It does not end with a comma.
struct ModemData {
  uint32_t source = 0;
  uint32_t destination = 0;
  Text text;
};

// Between a program of glidercc and a simulated vehicle. RECON has no such message.

/// #G: a text that only the two understand. It does not end with a comma.
struct SimulationText {
  Text text;
};

}  // namespace glider::hooks::recon
