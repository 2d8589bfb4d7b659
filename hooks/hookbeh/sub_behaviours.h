// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/args.h"
#include "hooks/hookbeh/command.h"
#include "hooks/hookbeh/hull.h"

/// The sub-behaviours that hookbeh generates, each a small value with its command for one cycle.
namespace glider::hooks {

/// Sinks at a given pitch until `depth >= target`.
struct DiveTo {
  double target_m = 0;
  double pitch_rad = 0;  ///< negative
  [[nodiscard]] bool reached(double depth_m) const { return depth_m >= target_m; }
  [[nodiscard]] VerticalCommand command(const HookbehArgs& args) const {
    return {pitch_rad, args.dive_pump_cc, Doing::DiveTo};
  }
};

/// Rises at a given pitch until `depth <= target`.
struct ClimbTo {
  double target_m = 0;
  double pitch_rad = 0;  ///< positive
  [[nodiscard]] bool reached(double depth_m) const { return depth_m <= target_m; }
  [[nodiscard]] VerticalCommand command(const HookbehArgs& args) const {
    return {pitch_rad, args.climb_pump_cc, Doing::ClimbTo};
  }
};

/// Keeps the last commands until the SBC sends its next instruction.
struct Hold {
  VerticalCommand kept;
  double left_s = 0;
  [[nodiscard]] VerticalCommand command() const {
    return {kept.pitch_rad, kept.pump_cc, Doing::Hold};
  }
};

/// Rises to the surface and stays there.
struct SurfaceNow {
  [[nodiscard]] VerticalCommand command(const HookbehArgs& args) const;
};

/// Keeps pump and pitch battery where the SBC has commanded them: no depth, no pitch.
struct FixedActuators {
  double pump_cc = 0;
  double battery_in = 0;
  /// A pump that is far in drives the vehicle down as a dive does, and what guards a dive guards
  /// this. With less the vehicle may sink, rise or stay, by its trim, as in a hover.
  [[nodiscard]] bool dives() const { return pump_cc <= -kFarInCc; }
  [[nodiscard]] VerticalCommand command(const HookbehArgs& args) const;

 private:
  /// cc; with less, the pump only trims the vehicle (DepthWatch).
  static constexpr double kFarInCc = 100;
};

/// The command with which hookbeh climbs by its own limits: the hull's full pump range, regardless
/// of the b_args for ordinary climbs.
VerticalCommand climbNow(Doing doing, const HookbehArgs& args, const Hull& hull);

/// The magnitude of pitch if the SBC gives none: 26 degrees, as in the vendor's yo, limited to the
/// b_args.
double usualPitch(const HookbehArgs& args);

}  // namespace glider::hooks
