// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/oracles/depth_judge.h"

#include "vehicles/slocum/oracles/judge_limits.h"
#include "vehicles/slocum/oracles/wrong_sensors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::slocum::oracles {

using hooks::HookState;

double sinkRate(double pitch_rad, double pump_cc) {
  constexpr double kNeutral = 60;  // cc on either side
  if (pump_cc > kNeutral) {
    return 0;
  }
  const bool driven = !(pump_cc >= -kNeutral) || !(pitch_rad >= 0);
  const double pitch = std::isnan(pitch_rad) ? limits::kSinkPitch : std::fabs(pitch_rad);
  const double steep = std::clamp(pitch, limits::kFlattestPitch, limits::kSinkPitch);
  return driven ? limits::kSinkMps * steep / limits::kSinkPitch : limits::kLevelSinkMps;
}

double DepthJudge::limitNow(bool active) const {
  const double without_sbc = s_.overdepth_m >= 0 ? s_.overdepth_m : s_.hull_m;
  return active ? s_.args.greatest_depth_m : without_sbc;
}

double DepthJudge::sinkRate(const CycleView& view) const {
  constexpr double kNan = __builtin_nan("");
  const bool known = !isWrong(s_.faults, {"c_pitch", "c_ballast_pumped"}, view.time_s, 0);
  return oracles::sinkRate(known ? view.array.get(Sensor::c_pitch) : kNan,
                           known ? view.array.get(Sensor::c_ballast_pumped) : kNan);
}

/// The flight controller did nothing since the previous cycle, and in this one it begins: its
/// commands take effect in the next. A vehicle that was past the limit before that climbs already:
/// another time without a flight controller takes it no deeper.
void DepthJudge::followDark(const CycleView& view) {
  const double gap_s = view.time_s - last_s_;
  if (s_.isDark(gap_s) && last_m_ <= usual_m_) {
    const double sunk = sinks_mps_ * (gap_s + s_.cycle_s);
    allowed_m_ = std::max(allowed_m_, last_m_ + sunk + limits::kTurnM);
  }
}

std::string DepthJudge::judgeDepth(const CycleView& view, bool active) {
  const double limit = limitNow(active);
  const double usual = deepestAllowed(s_.promiseAt(view.time_s).deepest, limit) + s_.late_m;
  followDark(view);
  usual_m_ = usual;
  allowed_m_ = std::max(usual, std::min(allowed_m_, view.true_depth_m + limits::kTurnM));
  if (view.true_depth_m > s_.hull_m) {
    return fmt::format("{:.1f} m deep, and the hull is made for {} m", view.true_depth_m,
                       s_.hull_m);
  }
  if (view.true_depth_m <= allowed_m_) {
    return "";
  }
  return fmt::format("{:.1f} m deep under {} {} m", view.true_depth_m,
                     active ? "max_depth" : "overdepth", limit);
}

std::string DepthJudge::cycle(const CycleView& view) {
  deepest_m_ = std::max(deepest_m_, view.true_depth_m);
  std::string wrong = judgeDepth(view, view.hook == HookState::Active);
  last_s_ = view.time_s;
  last_m_ = view.true_depth_m;
  sinks_mps_ = sinkRate(view);
  return wrong;
}

}  // namespace glider::slocum::oracles
