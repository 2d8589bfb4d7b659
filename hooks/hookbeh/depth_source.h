// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/cadence.h"
#include "hooks/hookbeh/hull.h"

namespace glider::hooks {

/// One sensor of the vehicle's depth, checked against what a vehicle can do.
class DepthSource {
 public:
  enum class Reading : unsigned char { Good, Missing, Jumped };

  explicit DepthSource(const Hull& hull) : hull_(hull) {}

  /// Takes in one cycle, `step_s` after the previous one. NaN: no reading.
  void observe(double depth_m, double step_s);
  [[nodiscard]] Reading reading() const { return reading_; }
  /// The newest good reading, m; while the sensor has been good for less than a minute, also a
  /// newer one that jumped. NaN before the first.
  [[nodiscard]] double depth() const { return depth_m_; }
  /// The age of that reading, s; NaN before the first.
  [[nodiscard]] double age() const { return age_s_; }
  /// How long the readings have been identical to the last bit, s. No two readings of a sensor that
  /// moves in the sea are.
  [[nodiscard]] double sameFor() const { return same_s_; }
  /// A sensor whose readings have been identical for this long is frozen, s: twice the usual time
  /// between its new readings, and a cycle, from 16 s to 36 s.
  [[nodiscard]] double patience() const;
  /// How long its readings have not continued the earlier good ones, s; each counts as a usual
  /// cycle, and for longer only where it is kept for longer than usual. Good readings in between
  /// reduce this by half of their own duration.
  [[nodiscard]] double jumpedFor() const { return jumped_s_; }

 private:
  [[nodiscard]] double counted(double step_s) const;

  Hull hull_;
  Cadence cadence_;
  double depth_m_ = __builtin_nan("");
  double age_s_ = __builtin_nan("");
  double same_s_ = 0;
  double jumped_s_ = 0;
  double good_s_ = 0;
  Reading reading_ = Reading::Missing;
};

}  // namespace glider::hooks
