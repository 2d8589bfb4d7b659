// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/args.h"
#include "hooks/hookbeh/command.h"
#include "hooks/protocol/values.h"

namespace glider::hooks {

/// hookbeh's own eyes: says when it must climb, whatever the SBC wants.
class Guard {
 public:
  /// Takes in one cycle, `step_s` after the one before. To be called in every cycle, also while
  /// another behaviour flies, so that the bottom is known when it matters.
  void observe(const Surroundings& now, double step_s);
  /// Why hookbeh must climb now ("climb: too deep"…), or null. Once too deep or too near the bottom
  /// it says so until the vehicle is a metre clear of the limits and `in_force` leads up or to a
  /// depth that is a metre clear too; or until it has climbed half of the depth where the limit was
  /// broken, at least 5 m: then the dive may be tried again, as far as the limit.
  const char* mustClimb(const HookbehArgs& args, const Instruction& in_force);
  /// Another SBC takes over: the reasons of the one before are forgotten, the bottom is not.
  void reset() { tripped_ = nullptr; }

 private:
  [[nodiscard]] bool keepsLimits(const HookbehArgs& args, double depth_m, double margin_m) const;
  [[nodiscard]] bool clearOfBottom(const HookbehArgs& args, double depth_m, double margin_m) const;
  [[nodiscard]] bool mayGoOn(const HookbehArgs& args, const Instruction& in_force) const;
  [[nodiscard]] bool hasClimbedFar() const;

  double depth_m_ = 0;
  bool depth_known_ = false;
  double altitude_m_ = -1;  // the newest that differed from the one before
  double bottom_m_ = 0;     // depth of the bottom when it came
  double bottom_age_s_ = 0;
  bool bottom_known_ = false;
  const char* tripped_ = nullptr;
  double tripped_depth_m_ = 0;  // the shallowest at which a limit was broken
};

}  // namespace glider::hooks
