// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::hooks {

/// Tells the new readings of a depth sensor from the cycles in which the sensor array keeps the
/// last one: the vehicle may read its pressure only every so many seconds (c_pressure_time), and
/// its cycles are not equally long. No two readings of a sensor that moves in the sea are identical
/// to the last bit.
class Cadence {
 public:
  /// Takes in one cycle, `step_s` after the previous one. NaN: no reading.
  void observe(double depth_m, double step_s);
  /// This cycle has a new reading.
  [[nodiscard]] bool isNew() const { return is_new_; }
  /// In a cycle with a new reading: since the one before, s. In any other: since the newest. NaN
  /// before there are any.
  [[nodiscard]] double gap() const { return since_s_; }
  /// It has learned usual(); before that it assumes a reading in each cycle.
  [[nodiscard]] bool isKnown() const;
  /// The usual time between two new readings, s. It follows slowly, so that a sensor that fails is
  /// still measured by what it was.
  [[nodiscard]] double usual() const { return usual_s_; }

 private:
  void learn(double gap_s);

  double last_m_ = __builtin_nan("");
  double since_s_ = __builtin_nan("");
  double usual_s_ = 4;
  double learned_ = 0;  ///< how many gaps it has learned from
  bool is_new_ = false;
};

}  // namespace glider::hooks
