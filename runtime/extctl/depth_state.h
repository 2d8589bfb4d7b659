// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::runtime::extctl {

/// Whether the vehicle still is at the surface, dives or climbs, as it last reported in
/// m_depth_state. It reports that only when it changes, and such a report may be lost. So the state
/// goes on while the vehicle's clock and its depth are reported, and the depth does not contradict.
class DepthState {
 public:
  /// The vehicle reports a state, with the newest depth.
  void report(double state);
  /// The depth of a control cycle, m, at `now_s` by the vehicle's clock. A depth that is NaN and
  /// a clock that goes back end the state.
  void look(double depth_m, double now_s);
  /// The state that goes on; NaN: none.
  [[nodiscard]] double state() const { return state_; }

  /// A depth so far back, m, contradicts a dive or a climb.
  static constexpr double kBack = 3;
  /// At the surface the vehicle is less deep, m. Slocums report the surface from 4 m on.
  static constexpr double kDeepestSurface = 5;
  /// Within this time, s, a dive or a climb goes on by kProgress, m: the slowest glides do.
  static constexpr double kProgressSecs = 60;
  static constexpr double kProgress = 0.5;

 private:
  static constexpr double kSurface = 0, kDiving = 1, kClimbing = 2;  ///< its values

  [[nodiscard]] bool contradicts();

  double state_ = __builtin_nan("");
  double depth_m_ = __builtin_nan("");  ///< newest
  double now_s_ = __builtin_nan("");
  double extreme_m_ = 0;  ///< since the report: deepest of a dive, shallowest of a climb
  double reached_m_ = 0, reached_s_ = 0;  ///< the last progress
};

}  // namespace glider::runtime::extctl
