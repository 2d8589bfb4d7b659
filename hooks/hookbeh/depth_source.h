// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/hull.h"

namespace glider::hooks {

/// One sensor of the vehicle's depth, held against what a vehicle can do.
class DepthSource {
 public:
  enum class Reading : unsigned char { Good, Missing, Jumped };

  explicit DepthSource(const Hull& hull) : hull_(hull) {}

  /// Takes in one cycle, `step_s` after the one before. NaN: it gave nothing.
  void observe(double depth_m, double step_s);
  [[nodiscard]] Reading reading() const { return reading_; }
  /// The newest good reading, m; NaN before the first.
  [[nodiscard]] double depth() const { return depth_m_; }
  /// How old that is, s; NaN before the first.
  [[nodiscard]] double age() const { return age_s_; }
  /// For so long the readings have been the same to the last bit, s. Of a sensor in the sea
  /// that is in motion no two are.
  [[nodiscard]] double sameFor() const { return same_s_; }
  /// For so long its readings have not followed on the good ones before, s. Good ones in between
  /// take away half of their own time.
  [[nodiscard]] double jumpedFor() const { return jumped_s_; }

 private:
  Hull hull_;
  double depth_m_ = __builtin_nan("");
  double raw_m_ = __builtin_nan("");  // the newest reading, good or not
  double age_s_ = __builtin_nan("");
  double same_s_ = 0;
  double jumped_s_ = 0;
  double good_s_ = 0;
  Reading reading_ = Reading::Missing;
};

}  // namespace glider::hooks
