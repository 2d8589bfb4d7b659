// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/depth_watch.h"

#include "hooks/protocol/numbers.h"

namespace glider::hooks {
namespace {

/// m; in real logs m_depth and the CTD's depth differ by 2.1 m at most, lag included.
constexpr double kAgreeM = 5;
/// s; a disagreement or a jump must last this long before it counts.
constexpr double kPersistsSecs = 10;
/// s; a CTD without a reading for longer counts as absent.
constexpr double kCtdLastsSecs = 20;
/// m; a sensor is frozen if it does not change for its patience() while the other moves this far.
constexpr double kWatchMovesM = 3;
/// s; the patience with a sensor that gives a reading in each cycle.
constexpr double kUsualPatienceSecs = 16;
/// s; the same in hover, where the vehicle may hardly move.
constexpr double kFrozenHoverSecs = 60;
/// cc; with less, the pump only trims the vehicle.
constexpr double kDrivesCc = 100;
/// m; above this depth m_depth may be clipped: it is never negative.
constexpr double kWatchClippedM = 1;
/// m; the CTD's depth changes by less in a vehicle that does not move.
constexpr double kWatchStillM = 0.5;
/// After this many seconds without a doubt the depth is believed again. Below, in m: the depth at
/// the surface.
constexpr double kQuietSecs = 60;
constexpr double kSurfacedM = 3;
constexpr double kClimbedSecs = 120;

}  // namespace

void DepthWatch::observe(const Surroundings& now, double step_s, double pump_cc) {
  own_.observe(now.depth_m, step_s);
  ctd_.observe(now.ctd_depth_m, step_s);
  own_lately_.observe(
      own_.reading() == DepthSource::Reading::Good ? own_.depth() : __builtin_nan(""), step_s);
  ctd_is_new_ = ctd_.age() == 0 && ctd_.sameFor() == 0;
  if (own_.sameFor() == 0) {
    ctd_at_own_change_m_ = ctd_.depth();
  }
  // A vehicle does not move by a jump: a CTD that says the same before and after it is not frozen.
  // Nor does a depth that is not believed show that it moves: at the surface a CTD rests.
  const bool own_jumps = own_.reading() == DepthSource::Reading::Jumped ||
                         (blind_ != HookGuard::None && ctd_.depth() < kWatchClippedM);
  if (ctd_is_new_ || own_jumps || own_jumped_) {
    own_at_ctd_change_m_ = own_.depth();
  }
  own_jumped_ = own_jumps;
  watchCtd(step_s);
  watchFrozen(pump_cc);
  watchLife(step_s);
  settle(now, step_s, pump_cc);
}

/// True if it gives readings, and they change when the vehicle moves.
bool DepthWatch::ctdLives() const {
  return ctd_.age() <= kCtdLastsSecs && !ctd_jumped_ && !ctd_frozen_;
}

void DepthWatch::watchCtd(double step_s) {
  const bool moved = magnitude(own_.depth() - own_at_ctd_change_m_) >= kWatchMovesM;
  ctd_frozen_ = (ctd_frozen_ && !ctd_is_new_) || (ctd_.sameFor() >= ctd_.patience() && moved);
  const bool own_good = own_.reading() == DepthSource::Reading::Good;
  const double apart = own_lately_.distanceTo(ctd_.depth());
  const bool near = ctd_.age() == 0 && apart <= kAgreeM;
  ctd_jumped_ =
      ctd_.reading() == DepthSource::Reading::Jumped || (ctd_jumped_ && !(own_good && near));
  if (!ctdLives()) {
    agree_s_ = disagree_s_ = 0;
    return;
  }
  if (!own_good) {
    agree_s_ = 0;
    return;
  }
  // An old reading of either does not show where the vehicle is now. While the sensor array keeps
  // the vehicle's own, only a distance that the vehicle cannot have moved meanwhile counts.
  const double kept_s = atMost(own_.sameFor(), own_.patience() - kUsualPatienceSecs);
  const bool beyond = apart > kAgreeM + hull_.vertical_rate_m_s * kept_s;
  if (ctd_.age() == 0 && (near || beyond)) {
    differs_ = !near;
  }
  agree_s_ = differs_ ? 0 : agree_s_ + step_s;
  disagree_s_ = differs_ ? disagree_s_ + step_s : 0;
  // One that is off by some metres agrees with a depth of some seconds ago, but not with this one.
  const bool here = magnitude(own_.depth() - ctd_.depth()) <= kAgreeM;
  ctd_known_ = ctd_known_ || (agree_s_ >= kPersistsSecs && here);
}

void DepthWatch::watchFrozen(double pump_cc) {
  const bool driven = pump_cc >= kDrivesCc || pump_cc <= -kDrivesCc;
  const double patience = driven ? own_.patience() : kFrozenHoverSecs;
  const bool same =
      isFinite(pump_cc) && own_.sameFor() >= patience && own_.depth() > kWatchClippedM;
  // The vehicle itself does not move, as another working sensor shows.
  const bool hangs = ctdLives() && ctd_.sameFor() < ctd_.patience() &&
                     magnitude(ctd_.depth() - ctd_at_own_change_m_) < kWatchStillM;
  frozen_ = (frozen_ && own_.sameFor() > 0) || (same && !hangs);
}

HookGuard DepthWatch::worst() const {
  // A disagreement counts only with a CTD reading of this cycle: a CTD that falls silent has none.
  const bool disagree = ctd_known_ && disagree_s_ >= kPersistsSecs && ctd_.age() == 0;
  return own_.jumpedFor() >= kPersistsSecs ? HookGuard::DepthJumps
         : frozen_                         ? HookGuard::DepthFrozen
         : disagree                        ? HookGuard::DepthsDisagree
                                           : HookGuard::None;
}

/// True if no fault is detectable in this cycle.
bool DepthWatch::isQuiet() const {
  const bool lives = own_.sameFor() < own_.patience() || own_.depth() <= kWatchClippedM;
  return own_.reading() == DepthSource::Reading::Good && lives && disagree_s_ == 0;
}

void DepthWatch::watchLife(double step_s) {
  const bool lives =
      own_.reading() == DepthSource::Reading::Good && own_.sameFor() < own_.patience();
  alive_s_ = lives || agree_s_ > 0 ? alive_s_ + step_s : 0;
}

void DepthWatch::settle(const Surroundings& now, double step_s, double pump_cc) {
  if (const HookGuard found = worst(); found != HookGuard::None) {
    // A depth that has jumped stays marked so: a lesser doubt must not make it believed sooner.
    blind_ = blind_ == HookGuard::DepthJumps ? blind_ : found;
    quiet_s_ = 0;
    climbed_s_ = 0;
    return;
  }
  quiet_s_ = isQuiet() ? quiet_s_ + step_s : 0;
  climbed_s_ += pump_cc > 0 ? step_s : 0;
  const bool surfaced = now.depth_m <= kSurfacedM && climbed_s_ >= kClimbedSecs;
  // Two sensors that agree are believed. One that was frozen is believed only where its reading is
  // known to be right: at the surface. One that has jumped may be wrong there too.
  const bool two = agree_s_ >= kQuietSecs && blind_ != HookGuard::DepthsDisagree;
  const bool one = surfaced && blind_ != HookGuard::DepthJumps;
  if (quiet_s_ >= kQuietSecs && (two || one)) {
    blind_ = HookGuard::None;
  }
}

HookGuard DepthWatch::doubt() const {
  return own_.reading() == DepthSource::Reading::Missing  ? HookGuard::DepthUnknown
         : own_.reading() == DepthSource::Reading::Jumped ? HookGuard::DepthJumps
                                                          : blind_;
}

double DepthWatch::depth() const {
  return doubt() == HookGuard::None ? own_.depth() : __builtin_nan("");
}

bool DepthWatch::isSeenByAnother() const {
  return agree_s_ > 0 && ctd_is_new_;
}

double DepthWatch::ctdDepth() const {
  return ctd_.reading() == DepthSource::Reading::Good ? ctd_.depth() : __builtin_nan("");
}

double DepthWatch::deepest() const {
  const bool ctd_counts = ctd_known_ && ctdLives() && ctd_.age() == 0;
  return ctd_counts ? atLeast(ctd_.depth(), own_.depth()) : own_.depth();
}

}  // namespace glider::hooks
