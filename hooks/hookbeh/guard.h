// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/args.h"
#include "hooks/hookbeh/bottom.h"
#include "hooks/hookbeh/command.h"
#include "hooks/hookbeh/depth_watch.h"
#include "hooks/hookbeh/headway.h"
#include "hooks/hookbeh/unseen_sink.h"
#include "hooks/protocol/instruction.h"

#include <stdint.h>

namespace glider::hooks {

/// hookbeh's own check of depth and altitude: decides when it must climb against any instruction of
/// the SBC.
class Guard {
 public:
  explicit Guard(const Hull& hull) : watch_(hull), unseen_(hull), by_ctd_(hull) {}
  /// Takes in one cycle, `step_s` after the previous one, in which hookbeh had commanded `last`
  /// (pump NaN: it commanded nothing) and drove the vehicle `way`. Must be called in every cycle,
  /// also while another behaviour is in control, so that the bottom is known when it matters.
  void observe(const HookbehArgs& args, const Surroundings& now, double step_s,
               const VerticalCommand& last, Way way);
  /// What the sensor array holds before the first cycle is not an echo.
  void ignore(double altitude_m) { bottom_.ignore(altitude_m); }
  /// Why hookbeh must climb now, or None. Once too deep or too near the bottom it returns that
  /// until the vehicle is a metre clear of the limits and `in_force` leads up or to a depth that is
  /// a metre clear too; or until it has climbed half of the depth where the limit was broken, at
  /// least 5 m: then the dive may be tried again, down to the limit. A depth that cannot be
  /// believed is a reason until it can be believed.
  HookGuard mustClimb(const HookbehArgs& args, const Instruction& in_force);
  /// The vehicle's own depth, m; NaN while it cannot be believed.
  [[nodiscard]] double depth() const { return watch_.depth(); }
  /// The vehicle must climb to see whether its depth follows: it may have sunk to its limit without
  /// the depth showing it, and no instruction moves it. Must be called after mustClimb() in each
  /// cycle in which hookbeh commands.
  bool mustShowDepth(const HookbehArgs& args, const Instruction& in_force);
  /// Another SBC takes over: limits that the previous one broke are forgotten; the bottom and
  /// faults of the depth are not.
  void reset();

 private:
  [[nodiscard]] HookGuard brokenLimit(const HookbehArgs& args, const Instruction& in_force) const;
  [[nodiscard]] bool sinksTooNear(const HookbehArgs& args, const Instruction& in_force) const;
  [[nodiscard]] HookGuard stall(const HookbehArgs& args, const Instruction& in_force) const;
  [[nodiscard]] double mostUnseen(const HookbehArgs& args, const Instruction& in_force) const;
  [[nodiscard]] bool mayBeFarDown(const HookbehArgs& args) const;
  [[nodiscard]] bool mayBeDeeper(const HookbehArgs& args, const Instruction& in_force) const;
  bool mustAsk(const HookbehArgs& args);
  void trip(HookGuard broken);
  [[nodiscard]] bool mayRelease(const HookbehArgs& args, const Instruction& in_force) const;
  [[nodiscard]] bool keepsLimits(const HookbehArgs& args, double depth_m) const;
  [[nodiscard]] bool clearOfBottom(const HookbehArgs& args, double depth_m) const;
  [[nodiscard]] bool mayGoOn(const HookbehArgs& args, const Instruction& in_force) const;
  [[nodiscard]] bool hasClimbedFar() const;

  DepthWatch watch_;
  Headway headway_;
  UnseenSink unseen_;
  UnseenSink by_ctd_;
  Bottom bottom_;
  double floor_m_ = kBottomless;          // of this cycle: by all that is known of the bottom
  double touched_floor_m_ = kBottomless;  // by contacts alone
  bool shows_ = false;                    // it climbs to see whether its depth follows
  bool asks_ = false;                     // the same, though another sensor agrees with it
  bool doubted_ = false;  // it climbed in the previous cycle: the depth was unknown or jumped
  double sinks_mps_ = 0;
  double depth_m_ = __builtin_nan("");  // for limits: DepthWatch::deepest()
  HookGuard tripped_ = HookGuard::None;
  double tripped_depth_m_ = __builtin_nan("");  // the shallowest at which a limit was broken
  double tripped_s_ = __builtin_nan("");        // since then
  double tries_after_s_ = 0;                    // a depth that repeats its zero after that time
  double down_from_m_ = __builtin_nan("");  // how deep it may have been before it was driven down
};

}  // namespace glider::hooks
