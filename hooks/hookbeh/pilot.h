// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/args.h"
#include "hooks/hookbeh/command.h"
#include "hooks/hookbeh/headway.h"
#include "hooks/hookbeh/hover.h"
#include "hooks/hookbeh/sub_behaviours.h"
#include "hooks/protocol/instruction.h"

#include <stdint.h>

namespace glider::hooks {

/// Turns the instruction in force into a sequence of sub-behaviours and runs them. Expects
/// instructions that passed checkBounds.
class Pilot {
 public:
  /// A new session: nothing is in force but `instruction`.
  void begin(const Instruction& instruction);
  /// A further instruction. If its vertical part is None or equals the one in force, that part
  /// changes nothing.
  void follow(const Instruction& instruction);
  /// The guard has stopped climbing: from its current depth the vehicle goes back to a depth that
  /// it had reached before; a hover that has only checked its depth (`checked`) by its pump alone,
  /// if that is near. Must be called before vertical().
  void goBack(const Surroundings& now, const HookbehArgs& args, bool checked);
  /// The commands for pitch and pump in this cycle, `step_s` after the previous one.
  VerticalCommand vertical(const Surroundings& now, double step_s, const HookbehArgs& args);
  /// Which way it drives the vehicle at `depth_m`. A hover drives it if it is farther from its
  /// depth than its pump alone explains, and a commanded pump if it is far in.
  [[nodiscard]] Way way(double depth_m) const;
  [[nodiscard]] LateralCommand lateral(const Surroundings& now) const;
  [[nodiscard]] const Instruction& inForce() const { return in_force_; }

 private:
  enum class Stage : uint8_t { Choose, Dive, Climb, Holding, Hovering, Surfacing, Actuators };
  void choose(const Surroundings& now, const HookbehArgs& args);
  void approach(const Surroundings& now, const HookbehArgs& args);
  void arrive(const VerticalCommand& kept, const HookbehArgs& args);
  void hoverOrSurface();
  void stopDive(const Surroundings& now);
  void advance(const Surroundings& now, double step_s, const HookbehArgs& args);

  Instruction in_force_;
  Stage stage_ = Stage::Choose;
  DiveTo dive_;
  ClimbTo climb_;
  Hold hold_;
  Hover hover_;
  SurfaceNow surface_;
  FixedActuators actuators_;
};

}  // namespace glider::hooks
