// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/oracles/needless_judge.h"

#include "hooks/hookbeh/hookbeh.h"
#include "vehicles/slocum/oracles/commanded.h"
#include "vehicles/slocum/oracles/judge_limits.h"
#include "vehicles/slocum/oracles/surface_judge.h"
#include "vehicles/slocum/oracles/wrong_sensors.h"

#include <fmt/format.h>

namespace glider::slocum::oracles {

using hooks::HookGuard;
using hooks::HookState;

namespace {

constexpr double kNear = 2;  // m from a limit
constexpr double kNeedlessRightSecs =
    300;                          // s: longer than any time over which a guard decides, but one
constexpr double kAnHour = 3600;  // s
constexpr double kSeesSecs = 8;   // s: two cycles

}  // namespace

bool NeedlessJudge::isSafe(const CycleView& view) const {
  const bool shallow = view.true_depth_m < s_.args.greatest_depth_m - kNear;
  const bool clear =
      s_.args.least_altitude_m < 0 || view.clearance_m > s_.args.least_altitude_m + kNear;
  return shallow && clear && !view.overridden() && readingsAreRight(view);
}

std::string NeedlessJudge::cycle(const CycleView& view) {
  const double step_s = s_.isDark(view.time_s - last_s_) ? 0 : view.time_s - last_s_;
  last_s_ = view.time_s;
  trust_.cycle(view, step_s);
  const bool active = view.hook == HookState::Active && view.hookbeh != nullptr;
  const bool guards = active && view.hookbeh->guard != HookGuard::None;
  echo_.cycle(view);
  // A depth that is frozen may have been so for too short a time to be wrong.
  const bool frozen = guards && view.hookbeh->guard == HookGuard::DepthFrozen &&
                      isWrong(s_.faults, {"m_depth", "m_pressure"}, view.time_s, kSeesSecs);
  const bool begins = guards && !guarding_ && !frozen && right_s_ > kNeedlessRightSecs &&
                      isSafe(view) &&
                      !isNearLimit(s_, view, view.hookbeh->guard, echo_.ageOfWhatHookbehKnows());
  needless_ = guards && (needless_ || begins);
  climbs_ += begins;
  // A reading that goes wrong meanwhile is a reason, and that it is not believed then.
  const bool right =
      !trust_.isLost() && !isWrong(s_.faults, {"m_depth", "m_pressure"}, view.time_s, 0);
  climb_s_ += needless_ && isSafe(view) && right ? step_s : 0;
  active_s_ += active ? step_s : 0;
  right_s_ = isSafe(view) ? right_s_ + step_s : 0;
  guarding_ = guards;
  if (climbs_ > limits::kNeedlessMore + limits::kNeedlessAnHour * active_s_ / kAnHour) {
    return fmt::format("{} climbs of guards in {:.0f} s though the vehicle was safe, now `{}`",
                       climbs_, active_s_, guards ? hookWordsForDoing(view.hookbeh->doing) : "");
  }
  return climb_s_ > limits::kNeedlessSecs + limits::kNeedlessShare * active_s_
             ? fmt::format(
                   "guards make the vehicle climb for {:.0f} of {:.0f} s although it is safe",
                   climb_s_, active_s_)
             : "";
}

}  // namespace glider::slocum::oracles
