// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

namespace glider::hooks {

/// The straight line through the newest readings of a depth: tells a vehicle that moves in swell
/// from a sensor that wavers about one value.
class Trend {
 public:
  void clear() { count_ = 0; }
  /// A reading, `gap_s` after the previous one.
  void add(double depth_m, double gap_s);
  /// How far the depth has moved along the line, m, positive downwards: over the fewest of the
  /// newest readings that show it beyond doubt; 0 if none do. `roughness_m`: how far readings
  /// usually are off the line of their neighbours. `fastest_mps`: no vehicle moves faster.
  [[nodiscard]] double moved(double roughness_m, double fastest_mps) const;

 private:
  static constexpr uint8_t kMost = 12;
  struct Reading {
    double at_s = 0;
    double depth_m = 0;
  };
  /// The line depth = offset + slope · time, times and depths from those of the newest reading.
  struct Line {
    double offset_m = 0, slope_mps = 0;
  };
  /// `back` 0: the newest.
  [[nodiscard]] const Reading& reading(uint8_t back) const {
    return readings_[(next_ + kMost - 1 - back) % kMost];
  }
  [[nodiscard]] Line through(uint8_t count) const;
  [[nodiscard]] double farthestFrom(const Line& line, uint8_t count) const;

  Reading readings_[kMost];
  uint8_t next_ = 0;
  uint8_t count_ = 0;
};

}  // namespace glider::hooks
