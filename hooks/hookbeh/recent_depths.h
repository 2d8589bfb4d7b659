// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

namespace glider::hooks {

/// The depths of the last 20 s, for comparison with the delayed readings of another sensor.
class RecentDepths {
 public:
  /// Takes in one cycle, `step_s` after the previous one. NaN: there was no depth.
  void observe(double depth_m, double step_s);
  /// How far `depth_m` is outside the depths of these seconds, m; 0 if within them, NaN if there
  /// are none.
  [[nodiscard]] double distanceTo(double depth_m) const;

 private:
  struct Sample {
    double depth_m = __builtin_nan("");
    double age_s = 0;
  };
  static constexpr uint8_t kCount = 10;
  Sample samples_[kCount];
  uint8_t next_ = 0;
};

}  // namespace glider::hooks
