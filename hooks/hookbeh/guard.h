// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/args.h"
#include "hooks/hookbeh/command.h"
#include "hooks/hookbeh/depth_watch.h"
#include "hooks/hookbeh/headway.h"
#include "hooks/hookbeh/unseen_sink.h"
#include "hooks/protocol/values.h"

#include <stdint.h>

namespace glider::hooks {

/// hookbeh's own eyes: says when it must climb, whatever the SBC wants.
class Guard {
 public:
  explicit Guard(const Hull& hull) : watch_(hull), unseen_(hull), by_ctd_(hull) {}
  /// Takes in one cycle, `step_s` after the one before, in which hookbeh had commanded `last`
  /// (pump NaN: it commanded nothing) and drove the vehicle `way`. To be called in every cycle,
  /// also while another behaviour flies, so that the bottom is known when it matters.
  void observe(const Surroundings& now, double step_s, const VerticalCommand& last, Way way);
  /// Why hookbeh must climb now, or None. Once too deep or too near the bottom it says so until
  /// the vehicle is a metre clear of the limits and `in_force` leads up or to a depth that is a
  /// metre clear too; or until it has climbed half of the depth where the limit was broken, at
  /// least 5 m: then the dive may be tried again, as far as the limit. A depth that cannot be
  /// believed is one until it can.
  HookGuard mustClimb(const HookbehArgs& args, const Instruction& in_force);
  /// The vehicle's own depth, m; NaN while it cannot be believed.
  [[nodiscard]] double depth() const { return watch_.depth(); }
  /// The vehicle must climb to see whether its depth follows: it may have sunk to its limit without
  /// the depth showing it, and nothing that it was instructed moves it. To be called after
  /// mustClimb() in each cycle in which hookbeh commands.
  bool mustShowDepth(const HookbehArgs& args, const Instruction& in_force);
  /// Another SBC takes over: the limits that the one before broke are forgotten, the bottom and
  /// what is wrong with the depth are not.
  void reset();

 private:
  void noteBottom(const Surroundings& now, double step_s);
  [[nodiscard]] HookGuard brokenLimit(const HookbehArgs& args) const;
  [[nodiscard]] HookGuard stall(const HookbehArgs& args, const Instruction& in_force) const;
  [[nodiscard]] double mostUnseen(const HookbehArgs& args, const Instruction& in_force) const;
  [[nodiscard]] bool mayBeFarDown(const HookbehArgs& args) const;
  [[nodiscard]] bool mayBeDeeper(const HookbehArgs& args, const Instruction& in_force) const;
  void trip(HookGuard broken);
  [[nodiscard]] bool mayLetGo(const HookbehArgs& args, const Instruction& in_force) const;
  [[nodiscard]] bool keepsLimits(const HookbehArgs& args, double depth_m) const;
  [[nodiscard]] bool clearOfBottom(const HookbehArgs& args, double depth_m) const;
  [[nodiscard]] bool mayGoOn(const HookbehArgs& args, const Instruction& in_force) const;
  [[nodiscard]] bool hasClimbedFar() const;

  DepthWatch watch_;
  Headway headway_;
  UnseenSink unseen_;
  UnseenSink by_ctd_;
  bool shows_ = false;    // it climbs to see whether its depth follows
  bool doubted_ = false;  // it climbed in the cycle before as the depth was unknown or jumped
  double depth_m_ = __builtin_nan("");     // the deepest of what can be believed
  double altitude_m_ = __builtin_nan("");  // the newest that differed from the one before
  double bottom_m_ = __builtin_nan("");    // depth of the bottom when it came
  double bottom_age_s_ = __builtin_nan("");
  bool bottom_known_ = false;
  HookGuard tripped_ = HookGuard::None;
  double tripped_depth_m_ = __builtin_nan("");  // the shallowest at which a limit was broken
  double tripped_s_ = __builtin_nan("");        // since then
  double down_from_m_ = __builtin_nan("");  // so deep it may have been before it was driven down
};

/// "climb: too deep"…, for logs; "" for None.
const char* wordsFor(HookGuard guard);

}  // namespace glider::hooks
