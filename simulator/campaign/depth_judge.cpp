// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/campaign/depth_judge.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::simulator {

using hooks::HookState;

namespace {

// The distance that the pump needs to reverse a steep dive, over a bottom that may rise meanwhile.
constexpr double kClearanceTolerance = 4;  // m
constexpr double kTouch = 0.05;            // m
constexpr double kUnderWater = 1;          // m
// After a longer time without a cycle, the flight controller was not running.
constexpr double kDarkCycles = 3;

}  // namespace

double DepthJudge::limitNow(bool active) const {
  const double without_sbc = s_.overdepth_m >= 0 ? s_.overdepth_m : s_.hull_m;
  return active ? s_.args.greatest_depth_m : without_sbc;
}

std::string DepthJudge::judgeDepth(const CycleView& view, bool active) {
  const double limit = limitNow(active);
  const double past = std::max(0.0, view.true_depth_m - limit);
  excess_m_ = limit != limit_m_ ? past : std::min(excess_m_, past);
  limit_m_ = limit;
  if (view.true_depth_m > s_.hull_m) {
    return fmt::format("{:.1f} m deep, and the hull is made for {} m", view.true_depth_m,
                       s_.hull_m);
  }
  const double allowed = deepestAllowed(s_.promise.deepest, limit) + excess_m_;
  if (view.true_depth_m <= allowed) {
    return "";
  }
  return fmt::format("{:.1f} m deep under {} {} m", view.true_depth_m,
                     active ? "max_depth" : "overdepth", limit);
}

/// A vehicle without a running flight controller keeps moving as before, and may meet the bottom.
bool DepthJudge::isNewOnBottom(const CycleView& view) {
  const bool touches = view.clearance_m < kTouch && view.true_depth_m > kUnderWater;
  const bool was_dark = view.time_s - cycle_at_s_ > kDarkCycles * s_.cycle_s;
  cycle_at_s_ = view.time_s;
  met_bottom_in_dark_ = touches && (met_bottom_in_dark_ || was_dark);
  return touches && !met_bottom_in_dark_;
}

std::string DepthJudge::judgeClearance(const CycleView& view, bool active) {
  if (!s_.promise.clearance || s_.args.least_altitude_m < 0) {
    return "";
  }
  const double lacking = std::max(0.0, s_.args.least_altitude_m - view.clearance_m);
  lacking_m_ = !was_active_ ? lacking : std::min(lacking_m_, lacking);
  if (isNewOnBottom(view)) {
    return "the vehicle is on the bottom";
  }
  if (active && lacking > kClearanceTolerance + lacking_m_) {
    return fmt::format("{:.1f} m over the bottom under min_altitude {} m", view.clearance_m,
                       s_.args.least_altitude_m);
  }
  return "";
}

std::string DepthJudge::cycle(const CycleView& view) {
  const bool active = view.hook == HookState::Active;
  deepest_m_ = std::max(deepest_m_, view.true_depth_m);
  std::string clearance = judgeClearance(view, active);
  was_active_ = active;
  std::string depth = judgeDepth(view, active);
  return depth.empty() ? clearance : depth;
}

}  // namespace glider::simulator
