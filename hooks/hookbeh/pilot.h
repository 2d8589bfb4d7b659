// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/args.h"
#include "hooks/hookbeh/command.h"
#include "hooks/hookbeh/headway.h"
#include "hooks/hookbeh/sub_behaviours.h"
#include "hooks/protocol/values.h"

#include <stdint.h>

namespace glider::hooks {

/// Turns the instruction in force into a sequence of sub-behaviours and runs them. Expects
/// instructions that passed checkBounds.
class Pilot {
 public:
  /// A new session: nothing is in force but `instruction`.
  void begin(const Instruction& instruction);
  /// A further instruction. Its vertical part, if it is none or equals the one in force, changes
  /// nothing.
  void follow(const Instruction& instruction);
  /// The guard, which climbed, has let go: from where the vehicle is now it goes back to a depth
  /// that it had reached before. To be called before vertical().
  void goBack(const Surroundings& now, const HookbehArgs& args);
  /// The commands for pitch and pump in this cycle, `step_s` after the one before.
  VerticalCommand vertical(const Surroundings& now, double step_s, const HookbehArgs& args);
  /// Which way it drives the vehicle that is at `depth_m`. A hover does where it is farther off its
  /// depth than its pump alone explains.
  [[nodiscard]] Way way(double depth_m) const;
  [[nodiscard]] LateralCommand lateral(const Surroundings& now) const;
  [[nodiscard]] const Instruction& inForce() const { return in_force_; }

 private:
  enum class Stage : uint8_t { Choose, Dive, Climb, Holding, Hovering, Surfacing };
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
};

}  // namespace glider::hooks
