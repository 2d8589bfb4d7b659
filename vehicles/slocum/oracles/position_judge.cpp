// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/oracles/position_judge.h"

#include "vehicles/slocum/oracles/judge_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::slocum::oracles {

using hooks::HookState;

namespace {

constexpr double kLand = 0.5;             // m of water: the hull lies on the ground
constexpr double kPositionAtSurface = 1;  // m
constexpr double kModelError = 0.05;      // m/s

}  // namespace

std::string PositionJudge::judgeShore(const CycleView& view, bool steered) {
  const double water_m = view.clearance_m + view.true_depth_m;
  if (water_m >= limits::kShoreM) {
    was_off_shore_ = true;
    return "";
  }
  // Wind and current may carry a vehicle that nothing steers.
  if (!was_off_shore_ || !steered) {
    return "";
  }
  return water_m < kLand
             ? "the vehicle is on land"
             : fmt::format("the vehicle is at the shore, in {:.1f} m of water", water_m);
}

std::string PositionJudge::judgeSpeed(const CycleView& view, bool floats) {
  floated_ = floated_ && floats;
  const double passed_s = view.time_s - from_s_;
  if (passed_s < limits::kSpeedSecs) {
    return "";
  }
  const double mps =
      std::hypot(view.east_m - from_east_m_, view.north_m - from_north_m_) / passed_s;
  const bool floated = floated_;
  from_s_ = view.time_s;
  from_east_m_ = view.east_m;
  from_north_m_ = view.north_m;
  floated_ = floats;
  if (floated && mps > s_.current_mps + limits::kDriftMps) {
    return fmt::format("drifts at {:.2f} m/s without control, and the current is {:.2f} m/s", mps,
                       s_.current_mps);
  }
  return mps > s_.through_water_mps + s_.current_mps + kModelError
             ? fmt::format(
                   "travels at {:.2f} m/s, and the vehicle makes {} m/s in a current of "
                   "{:.2f} m/s",
                   mps, s_.through_water_mps, s_.current_mps)
             : "";
}

std::string PositionJudge::cycle(const CycleView& view) {
  const bool steered = !view.aborted && (view.hook == HookState::Active || !s_.only_hookbeh);
  std::string shore = judgeShore(view, steered);
  std::string speed = judgeSpeed(view, !steered && view.true_depth_m < kPositionAtSurface);
  return shore.empty() ? speed : shore;
}

}  // namespace glider::slocum::oracles
