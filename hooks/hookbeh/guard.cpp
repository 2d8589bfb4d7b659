// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/guard.h"

#include "hooks/hookbeh/hull.h"
#include "hooks/protocol/numbers.h"

namespace glider::hooks {
namespace {

constexpr double kClearM = 1.0;
/// After a dive that broke a limit, the guard makes the vehicle climb by this share of the depth
/// where it stepped in, and by at least this many metres, before the dive may be tried again.
/// Without that the pump would never rest.
constexpr double kRetryShare = 0.5;
constexpr double kRetryM = 5.0;
/// m; the altitude over a bottom that it has touched, for a vehicle that uses no altimeter.
constexpr double kWithoutAltimeterM = 3;
/// s; how long the vehicle sinks on after it has been commanded to climb. Below, in m/s: the
/// fastest that it sinks; a rate above that is false.
constexpr double kTurnsSecs = 8;
constexpr double kFastestMps = 0.5;
/// s without a metre gained: the defaults of the vendor's dive_to and climb_to
/// (stop_when_hover_for, stop_when_stalled_for).
constexpr double kHoverSecs = 180;
constexpr double kStalledSecs = 240;
/// m that the vehicle may sink unseen even at its greatest depth: a smaller value would end a dive
/// that waves or a layer slow down. The slowest metre of a dive in real logs takes 16 s.
constexpr double kLeastUnseenM = 7;
/// m; a dive ends if it may be this far past its target, and this far past the depth last shown.
constexpr double kPastTargetM = 8;
constexpr double kPastShownM = 10;
/// m; the same before the depth has moved at all.
constexpr double kMostUnseenAtFirstM = 20;
/// Two sensors may be wrong: how far one dive may lead past the greatest depth, as a share of it;
/// below, the least such distance in metres, in the dive and at the steepest pitch.
constexpr double kPastShare = 0.44;
constexpr double kLeastInDiveM = 11;
constexpr double kLeastSteeplyM = 18;
/// At the steepest possible pitch the vehicle is assumed to sink so many times as fast as usual.
constexpr double kSteeplyTimes = 1.7;
/// m; a vehicle that may have sunk so far since its depth last answered climbs to see whether it
/// does: the distance to the greatest depth, between these. At 0.1 m/s, 300 and 600 s of hover.
constexpr double kAsksM = 30;
constexpr double kAsksLatestM = 60;
/// s; a depth below the second, in m, that does not answer to a climb of this length is not
/// believed.
constexpr double kAnswersSecs = 180;
constexpr double kAnswersBelowM = 3;
/// m; a vehicle that has just left the depth where it stood is within this distance of it.
constexpr double kStoodNearM = 2;
/// m; at this depth or above, the vehicle is at the surface.
constexpr double kAtSurfaceM = 1;
/// s of climbing after a dive that gained no depth, and s for which the sensor must have worked:
/// then it is believed again.
constexpr double kHomeSecs = 600;
constexpr double kAliveSecs = 60;
/// s; the longest until a depth that repeats its zero at the surface is tried again.
constexpr double kMostHomeSecs = 7200;

/// A depth to fly to.
bool hasTarget(const Instruction& in_force) {
  return in_force.vertical == HookVertical::Descend || in_force.vertical == HookVertical::Ascend ||
         in_force.vertical == HookVertical::Hover;
}

bool isDepthDoubt(HookGuard guard) {
  return guard == HookGuard::DepthUnknown || guard == HookGuard::DepthJumps;
}

}  // namespace

void Guard::observe(const HookbehArgs& args, const Surroundings& now, double step_s,
                    const VerticalCommand& last, Way way) {
  watch_.observe(now, step_s, last.pump_cc);
  depth_m_ = watch_.deepest();
  const bool known = watch_.doubt() == HookGuard::None;
  const double stood_m = headway_.standsAt();
  if (known && !doubted_) {  // an occasional missing reading must not clear it
    headway_.observe(way, watch_.depth(), step_s);
  } else {
    headway_.interrupt();
  }
  // In any way that the dive ended; but a depth that is believed again may be another one.
  if (headway_.way() != Way::Down && magnitude(watch_.depth() - stood_m) <= kStoodNearM) {
    bottom_.noteStop();
  }
  unseen_.observe(watch_.depth(), step_s, last);
  const double deepest = unseen_.deepest();
  down_from_m_ = way == Way::Down ? atMost(deepest, down_from_m_) : deepest;
  by_ctd_.observe(watch_.ctdDepth(), step_s, last);
  if (by_ctd_.hasMoved() && !unseen_.hasMoved()) {
    watch_.believeCtd();  // the CTD works, and the depth sensor does not
  }
  if (watch_.isSeenByAnother()) {
    unseen_.confirm(watch_.depth());
  }
  tripped_s_ += step_s;
  sinks_mps_ = isFinite(now.depth_rate_mps) ? between(now.depth_rate_mps, 0, kFastestMps) : 0;
  bottom_.move(now, args.least_altitude_m, step_s);
  bottom_.observe(now, watch_.depth(), args.least_altitude_m, step_s);
  bottom_.follow(step_s);
  floor_m_ = bottom_.floor();
  touched_floor_m_ = bottom_.touchedFloor();
}

void Guard::reset() {
  // A vehicle that could not detect that it sinks cannot detect it for another SBC either.
  if (tripped_ != HookGuard::NoDepthGained) {
    tripped_ = HookGuard::None;
  }
}

HookGuard Guard::brokenLimit(const HookbehArgs& args, const Instruction& in_force) const {
  // All comparisons are written so that a NaN among the b_args counts as a broken limit.
  return !(depth_m_ <= args.greatest_depth_m)                             ? HookGuard::TooDeep
         : !clearOfBottom(args, depth_m_) || sinksTooNear(args, in_force) ? HookGuard::NearBottom
                                                                          : HookGuard::None;
}

/// True if the vehicle sinks towards a target that is too near the bottom, and would be too near it
/// before it has turned. At a target that is clear of the bottom it turns by itself.
bool Guard::sinksTooNear(const HookbehArgs& args, const Instruction& in_force) const {
  return !clearOfBottom(args, depth_m_ + kTurnsSecs * sinks_mps_) && !mayGoOn(args, in_force);
}

HookGuard Guard::stall(const HookbehArgs& args, const Instruction& in_force) const {
  if (asks_ && unseen_.drivenUpFor() >= kAnswersSecs && depth_m_ > kAnswersBelowM) {
    return HookGuard::NoDepthGained;  // no sensor follows the vehicle
  }
  if (headway_.way() == Way::Up) {
    return headway_.idleFor() >= kStalledSecs ? HookGuard::NoHeightGained : HookGuard::None;
  }
  const double most = mostUnseen(args, in_force);
  // What it may have sunk before this dive is left to a climb that checks the depth.
  const double own = atMost(most - unseen_.shown(), kPastShownM + unseen_.lateBy());
  const bool sinks = unseen_.deepest() >= most && !(unseen_.deepest() < down_from_m_ + own);
  const bool ends = headway_.idleFor() >= kHoverSecs || sinks || mayBeFarDown(args);
  return headway_.way() == Way::Down && ends ? HookGuard::NoDepthGained : HookGuard::None;
}

/// How deep the vehicle may be before its depth must show it, m.
double Guard::mostUnseen(const HookbehArgs& args, const Instruction& in_force) const {
  const double shown = unseen_.shown();
  const double late = unseen_.lateBy();
  double most = atLeast(shown + kLeastUnseenM + late, args.greatest_depth_m);
  if (!unseen_.hasMoved()) {
    most = atMost(shown + kMostUnseenAtFirstM, most);
  }
  if (in_force.vertical == HookVertical::Descend) {
    most = atMost(atLeast(in_force.depth_m + kPastTargetM, shown + kPastShownM) + late, most);
  }
  return most;
}

/// True if the dive itself may have led past all limits, even against a second sensor: both may be
/// wrong.
bool Guard::mayBeFarDown(const HookbehArgs& args) const {
  const double left = args.greatest_depth_m - unseen_.shown() + kPastShare * args.greatest_depth_m;
  const double late = unseen_.lateBy();
  return unseen_.sunkInDive() >= atLeast(left, kLeastInDiveM) + late ||
         unseen_.sunkSteeply() >= atLeast(left, kLeastSteeplyM) + kSteeplyTimes * late;
}

bool Guard::mayBeDeeper(const HookbehArgs& args, const Instruction& in_force) const {
  return unseen_.deepest() >= mostUnseen(args, in_force) || mayBeFarDown(args);
}

bool Guard::mustShowDepth(const HookbehArgs& args, const Instruction& in_force) {
  shows_ = mayBeDeeper(args, in_force) || (shows_ && unseen_.deepest() > unseen_.shown());
  return mustAsk(args) || shows_;
}

/// True if the vehicle must climb to see whether its depth answers, whoever agrees with it: what
/// sticks in one sensor of pressure may stick in the other. Until it answers, or the vehicle must
/// be at the surface.
bool Guard::mustAsk(const HookbehArgs& args) {
  const double most = between(args.greatest_depth_m - unseen_.answered(), kAsksM, kAsksLatestM);
  // A dive and a climb have rules of their own.
  const bool adrift = headway_.way() == Way::None && unseen_.unanswered() >= most;
  asks_ = adrift || (asks_ && unseen_.unanswered() > 0);
  return asks_;
}

void Guard::trip(HookGuard broken) {
  if (broken == HookGuard::NoDepthGained && tripped_ != broken) {
    tries_after_s_ = between(2 * tries_after_s_, kHomeSecs, kMostHomeSecs);
  }
  if (tripped_ == HookGuard::None) {
    tripped_s_ = 0;
  }
  if (tripped_ == HookGuard::None || depth_m_ < tripped_depth_m_) {
    tripped_depth_m_ = depth_m_;
  }
  tripped_ = broken;
}

HookGuard Guard::mustClimb(const HookbehArgs& args, const Instruction& in_force) {
  const HookGuard doubt = watch_.doubt();
  doubted_ = isDepthDoubt(doubt);
  if (doubted_) {
    return doubt;
  }
  const HookGuard broken = brokenLimit(args, in_force);
  // A vehicle that climbs after a dive that stopped has just learned where the bottom is.
  const bool learned = broken == HookGuard::NearBottom && tripped_ == HookGuard::NoDepthGained;
  if (broken != HookGuard::None && !learned) {
    trip(broken);
  } else if (const HookGuard stalled = stall(args, in_force); stalled != HookGuard::None) {
    // A dive that has just begun again may only have gone on unseen before.
    if (stalled == HookGuard::NoDepthGained && tripped_ != stalled && headway_.mayHaveStopped()) {
      bottom_.noteStop();
    }
    trip(stalled);
  } else if (mayRelease(args, in_force)) {
    tries_after_s_ = hasClimbedFar() ? 0 : tries_after_s_;
    tripped_ = HookGuard::None;
  }
  return doubt != HookGuard::None ? doubt : tripped_;
}

bool Guard::mayRelease(const HookbehArgs& args, const Instruction& in_force) const {
  if (tripped_ == HookGuard::NoDepthGained) {
    const bool alive = tripped_s_ >= kHomeSecs && watch_.aliveFor() >= kAliveSecs;
    // At the surface a depth that works may repeat its zero, and so may one that is stuck: it is
    // tried again, more and more rarely.
    const bool tries = tripped_s_ >= tries_after_s_ && depth_m_ <= 0;
    return hasClimbedFar() || ((alive || tries) && unseen_.deepest() <= kAtSurfaceM);
  }
  if (tripped_ == HookGuard::NoHeightGained) {
    const bool there = in_force.vertical == HookVertical::Actuators && depth_m_ <= kAtSurfaceM;
    return tripped_depth_m_ - depth_m_ >= kClearM || there ||
           (hasTarget(in_force) && in_force.depth_m > depth_m_);
  }
  // At the surface it can climb no farther, wherever the limit was broken.
  const bool up = depth_m_ <= kAtSurfaceM && keepsLimits(args, kRetryM + kClearM);
  return keepsLimits(args, depth_m_ + kClearM) &&
         (mayGoOn(args, in_force) || hasClimbedFar() || up);
}

bool Guard::keepsLimits(const HookbehArgs& args, double depth_m) const {
  return depth_m <= args.greatest_depth_m && clearOfBottom(args, depth_m);
}

bool Guard::clearOfBottom(const HookbehArgs& args, double depth_m) const {
  const bool by_echo = !(args.least_altitude_m < 0);
  const double floor = by_echo ? floor_m_ : touched_floor_m_;
  const double least = by_echo ? args.least_altitude_m : kWithoutAltimeterM;
  return !isKnown(floor) || floor - depth_m >= least;
}

bool Guard::mayGoOn(const HookbehArgs& args, const Instruction& in_force) const {
  if (in_force.vertical == HookVertical::Actuators) {
    return false;  // wherever they lead
  }
  // This also holds for an ascend: once the vehicle is above its target, hovering there leads down.
  return !hasTarget(in_force) || keepsLimits(args, in_force.depth_m + kClearM);
}

bool Guard::hasClimbedFar() const {
  return tripped_depth_m_ - depth_m_ >= atLeast(kRetryShare * tripped_depth_m_, kRetryM);
}

}  // namespace glider::hooks
