// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/library/thermocline.h"
#include "runtime/library/yo.h"

/// Finds a thermocline and keeps a window round it, leg by leg. A leg is a dive or a climb.
namespace glider::runtime {

/// What counts as a thermocline: a difference of `dtemp` K within `ddepth` m.
struct ThermoclineWanted {
  double dtemp = 0;
  double ddepth = 0;
};

class ThermoclineTracker {
 public:
  /// The window reaches this part of ddepth to both sides of the thermocline. Less than half: the
  /// upper and the lower end are ordered at different moments, between which an internal wave moves
  /// the thermocline, and both together are to stay within about ddepth.
  static constexpr double kHalfWindow = 0.4;

  /// Steeper than any thermocline that is not met twice, K/m.
  static constexpr double kSteepest = 10;

  /// A smaller move of the thermocline, m, is not worth a message to the vehicle.
  static constexpr double kLeastMove = 0.2;

  /// Forgets everything: searches.
  void start(double time);
  /// A dive or climb begins now. When the last dive and climb both met no thermocline, it searches
  /// again.
  void beginLeg(double time);
  /// A reading: depth in m, temperature in degC.
  void record(double time, double depth, double temperature, const ThermoclineWanted& wanted);

  [[nodiscard]] bool tracking() const { return tracking_ != 0; }
  /// Depth of the thermocline, m, while tracking.
  [[nodiscard]] double centre() const { return centre_; }
  /// The part of `full` to fly in now.
  [[nodiscard]] YoRange window(const YoRange& full, const ThermoclineWanted& wanted) const;

 private:
  void follow(const Crossing& crossing, double reach);

  double leg_began_;
  double middle_;     ///< degC, the temperature halfway through the thermocline
  double centre_;     ///< m
  double candidate_;  ///< m, a crossing out of reach that the last leg met; NaN: none
  double outlier_;    ///< m, one that this leg met; NaN: none
  uint32_t tracking_;
  uint32_t met_;         ///< this leg has met the difference
  uint32_t met_before_;  ///< the leg before did
  uint32_t reserved_;
  WaterColumn column_;
};

}  // namespace glider::runtime
