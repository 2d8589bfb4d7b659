// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/command.h"
#include "hooks/hookbeh/depth_source.h"
#include "hooks/hookbeh/recent_depths.h"

namespace glider::hooks {

/// Decides whether the vehicle's depth can be believed. Compares the depth sensor with its own
/// earlier readings, with what the vehicle was commanded to do, and with the CTD if there is one.
class DepthWatch {
 public:
  explicit DepthWatch(const Hull& hull) : hull_(hull), own_(hull), ctd_(hull) {}
  /// Takes in one cycle, `step_s` after the previous one, in which the pump was commanded to
  /// `pump_cc` by hookbeh; NaN if it commanded nothing. Must be called in every cycle.
  void observe(const Surroundings& now, double step_s, double pump_cc);

  /// Why the depth cannot be believed in this cycle; None if it can.
  [[nodiscard]] HookGuard doubt() const;
  /// The vehicle's own depth, m; NaN while it cannot be believed.
  [[nodiscard]] double depth() const;
  /// For limits, m: the newest depth of the vehicle's own sensor, also while depth() is not known;
  /// or that of the CTD, if it is deeper, of this cycle, and from a CTD that works. NaN before the
  /// vehicle's own first reading.
  [[nodiscard]] double deepest() const;
  /// True if a new reading of the CTD, which changes, agrees in this cycle.
  [[nodiscard]] bool isSeenByAnother() const;
  /// The CTD's depth if it is new in this cycle, m; else NaN.
  [[nodiscard]] double ctdDepth() const;
  /// Records that the CTD works, though it has never agreed.
  void believeCtd() { ctd_known_ = true; }
  /// How long the vehicle's own sensor has worked, s: its readings changed, or the CTD's agreed.
  [[nodiscard]] double aliveFor() const { return alive_s_; }

 private:
  [[nodiscard]] bool ctdLives() const;
  void watchCtd(double step_s);
  void watchFrozen(double pump_cc);
  void watchLife(double step_s);
  void settle(const Surroundings& now, double step_s, double pump_cc);
  [[nodiscard]] bool isQuiet() const;
  [[nodiscard]] HookGuard worst() const;

  Hull hull_;
  DepthSource own_;
  RecentDepths own_lately_;  // a reading of the CTD may be some seconds old
  DepthSource ctd_;
  bool ctd_is_new_ = false;                         // it differs from the previous one
  bool ctd_jumped_ = false;                         // and has not agreed since
  bool own_jumped_ = false;                         // in the cycle before
  bool ctd_frozen_ = false;                         // until it moves
  bool differs_ = false;                            // the two differed when last compared
  double own_at_ctd_change_m_ = __builtin_nan("");  // own depth when the CTD's last changed
  double ctd_at_own_change_m_ = __builtin_nan("");  // CTD's depth when the own last changed
  bool ctd_known_ = false;  // it has agreed once: the vehicle carries one that works
  double agree_s_ = 0;      // how long the two have agreed, s
  double disagree_s_ = 0;
  double alive_s_ = 0;
  bool frozen_ = false;
  HookGuard blind_ = HookGuard::None;  // why the depth is not believed; None: it is
  double quiet_s_ = 0;                 // while blind: how long no fault was seen, s
  double climbed_s_ = 0;               // while blind: how long the pump was out, s
};

}  // namespace glider::hooks
