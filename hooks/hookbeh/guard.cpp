// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/guard.h"

#include "hooks/protocol/numbers.h"

namespace glider::hooks {
namespace {

constexpr double kClearM = 1.0;
/// So much of the depth where it came in, and at least so many metres, the guard climbs before it
/// lets a dive that broke a limit be tried again: without that the pump would never rest.
constexpr double kRetryShare = 0.5;
constexpr double kRetryM = 5.0;
/// An echo of the bottom is forgotten after this long: the vehicle has moved on, and the echo may
/// have been a fish.
constexpr double kBottomLastsSecs = 600.0;

}  // namespace

void Guard::observe(const Surroundings& now, double step_s) {
  depth_m_ = now.depth_m;
  depth_known_ = isFinite(now.depth_m);
  bottom_age_s_ += step_s;
  if (bottom_age_s_ > kBottomLastsSecs) {
    bottom_known_ = false;
  }
  // The sensor array keeps an old altitude when the altimeter hears nothing, so only a changed one
  // is an echo. Between echoes the clearance follows from the depth, which also catches an
  // altimeter that is stuck.
  const bool echo =
      now.altitude_m >= 0 && isFinite(now.altitude_m) && now.altitude_m != altitude_m_;
  if (echo && depth_known_) {
    altitude_m_ = now.altitude_m;
    bottom_m_ = depth_m_ + altitude_m_;
    bottom_age_s_ = 0;
    bottom_known_ = true;
  }
}

const char* Guard::mustClimb(const HookbehArgs& args, const Instruction& in_force) {
  if (!depth_known_) {
    return "climb: depth unknown";
  }
  // All comparisons are written so that a NaN among the b_args counts as a broken limit.
  const char* broken = !(depth_m_ <= args.greatest_depth_m) ? "climb: too deep"
                       : !clearOfBottom(args, depth_m_, 0)  ? "climb: too near the bottom"
                                                            : nullptr;
  if (broken != nullptr) {
    if (tripped_ == nullptr || depth_m_ < tripped_depth_m_) {
      tripped_depth_m_ = depth_m_;
    }
    tripped_ = broken;
  } else if (tripped_ != nullptr && keepsLimits(args, depth_m_, kClearM) &&
             (mayGoOn(args, in_force) || hasClimbedFar())) {
    tripped_ = nullptr;
  }
  return tripped_;
}

bool Guard::keepsLimits(const HookbehArgs& args, double depth_m, double margin_m) const {
  return depth_m <= args.greatest_depth_m - margin_m && clearOfBottom(args, depth_m, margin_m);
}

bool Guard::clearOfBottom(const HookbehArgs& args, double depth_m, double margin_m) const {
  if (!bottom_known_ || args.least_altitude_m < 0) {
    return true;
  }
  return bottom_m_ - depth_m >= args.least_altitude_m + margin_m;
}

bool Guard::mayGoOn(const HookbehArgs& args, const Instruction& in_force) const {
  switch (in_force.vertical) {
    case HookVertical::Ascend:
      // Once it is above its target, hovering there leads down.
      return depth_m_ > in_force.depth_m || keepsLimits(args, in_force.depth_m, kClearM);
    case HookVertical::Descend:
    case HookVertical::Hover:
      return keepsLimits(args, in_force.depth_m, kClearM);
    case HookVertical::None:
    case HookVertical::Surface:
      return true;
  }
  return false;
}

bool Guard::hasClimbedFar() const {
  const double share = kRetryShare * tripped_depth_m_;
  return tripped_depth_m_ - depth_m_ >= (share > kRetryM ? share : kRetryM);
}

}  // namespace glider::hooks
