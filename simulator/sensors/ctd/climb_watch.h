// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>

namespace glider::simulator {

/// Distinguishes climbs from dives by the true depth.
class ClimbWatch {
 public:
  /// Call with every depth, in order of time.
  void note(double depth_m, double now_s) {
    // A vehicle that heaves by less than this has not turned.
    constexpr double kTurned = 0.5;  // m
    extreme_ = climbing_ ? std::min(extreme_, depth_m) : std::max(extreme_, depth_m);
    const double back = climbing_ ? depth_m - extreme_ : extreme_ - depth_m;
    if (back > kTurned) {
      climbing_ = !climbing_;
      extreme_ = depth_m;
      since_s_ = now_s;
    }
  }
  [[nodiscard]] bool climbing() const { return climbing_; }
  /// When the newest climb or dive was detected.
  [[nodiscard]] double since() const { return since_s_; }

 private:
  bool climbing_ = false;
  double extreme_ = 0, since_s_ = 0;
};

}  // namespace glider::simulator
