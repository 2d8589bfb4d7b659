// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/command.h"
#include "hooks/hookbeh/depth_source.h"
#include "hooks/hookbeh/recent_depths.h"

namespace glider::hooks {

/// Whether the vehicle's depth can be believed. Holds the depth sensor against itself, against
/// what the vehicle was told to do, and against the CTD where there is one.
class DepthWatch {
 public:
  explicit DepthWatch(const Hull& hull) : own_(hull), ctd_(hull) {}
  /// Takes in one cycle, `step_s` after the one before, in which the pump was commanded to
  /// `pump_cc` by hookbeh; NaN where it commanded nothing. To be called in every cycle.
  void observe(const Surroundings& now, double step_s, double pump_cc);

  /// Why the depth cannot be believed in this cycle; None if it can.
  [[nodiscard]] HookGuard doubt() const;
  /// The vehicle's own depth, m; NaN while it cannot be believed.
  [[nodiscard]] double depth() const;
  /// The deeper of the vehicle's own and the CTD's, for limits; NaN where doubt() says Unknown.
  [[nodiscard]] double deepest() const;
  /// A new reading of the CTD, which moves, says the same in this cycle.
  [[nodiscard]] bool isSeenByAnother() const;
  /// The CTD's depth, where it is new in this cycle, m; else NaN.
  [[nodiscard]] double ctdDepth() const;
  /// The CTD works, though it has never agreed.
  void believeCtd() { ctd_known_ = true; }
  /// For so long the readings have not been the same to the last bit, or the CTD's has agreed, s.
  [[nodiscard]] double aliveFor() const { return alive_s_; }

 private:
  [[nodiscard]] bool ctdLives() const;
  void watchCtd(double step_s);
  void watchFrozen(double pump_cc);
  void watchLife(double step_s);
  void settle(const Surroundings& now, double step_s, double pump_cc);
  [[nodiscard]] bool isQuiet() const;
  [[nodiscard]] HookGuard worst() const;

  DepthSource own_;
  RecentDepths own_lately_;  // what the CTD says may be some seconds old
  DepthSource ctd_;
  bool ctd_is_new_ = false;                         // it differs from the one before
  bool ctd_jumped_ = false;                         // and has not agreed since
  bool ctd_frozen_ = false;                         // until it moves
  bool differs_ = false;                            // the two, when they were last compared
  double own_at_ctd_change_m_ = __builtin_nan("");  // own depth when the CTD's last changed
  double ctd_at_own_change_m_ = __builtin_nan("");  // the CTD's depth when the own last changed
  bool ctd_known_ = false;  // it has agreed once: the vehicle carries one that works
  double agree_s_ = 0;      // for so long the two agree
  double disagree_s_ = 0;
  double alive_s_ = 0;
  bool frozen_ = false;
  HookGuard blind_ = HookGuard::None;  // since then the depth is not believed
  double quiet_s_ = 0;                 // while blind: for so long nothing was wrong
  double climbed_s_ = 0;               // while blind: for so long the pump was out
};

}  // namespace glider::hooks
