// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/command.h"
#include "hooks/hookbeh/hull.h"

namespace glider::hooks {

/// Estimates how deep the vehicle may be, from what it was commanded since its depth last showed
/// that it moves as commanded. Detects a depth that has stopped, flickers about one value, or
/// arrives only now and then: such readings do not count.
class UnseenSink {
 public:
  explicit UnseenSink(const Hull& hull) : hull_(hull) {}
  /// Takes in one cycle, `step_s` after the previous one, at the beginning of which the vehicle had
  /// been commanded `last` (pump NaN: by another behaviour, or not as hookbeh commanded).
  /// `depth_m`: NaN while it is not believed.
  void observe(double depth_m, double step_s, const VerticalCommand& last);
  /// Another working sensor reports that the vehicle is at `depth_m`.
  void confirm(double depth_m);
  /// The vehicle is at most this deep, m; NaN before the first depth.
  [[nodiscard]] double deepest() const { return deepest_m_; }
  /// The depth when it last showed that it moves, or the very first depth, m.
  [[nodiscard]] double shown() const { return shown_m_; }
  /// The depth has moved as commanded since hookbeh began.
  [[nodiscard]] bool hasMoved() const { return has_moved_; }
  /// How far it may have sunk in the current dive, m, without regard to another sensor: both may be
  /// wrong.
  [[nodiscard]] double sunkInDive() const { return in_dive_m_; }
  /// The same at the steepest possible pitch, because its pitch may be wrong; here another sensor
  /// counts.
  [[nodiscard]] double sunkSteeply() const { return steeply_m_; }

 private:
  /// The fastest the vehicle sinks, m/s: at its steepest pitch, or at this one.
  [[nodiscard]] double steepestRate() const;
  [[nodiscard]] double rateAt(double pitch_rad) const;
  void reckon(double step_s, const VerticalCommand& last);
  void follow(double depth_m, double step_s);
  void seek(double depth_m);
  void show(double depth_m);

  Hull hull_;
  double deepest_m_ = __builtin_nan("");
  double shown_m_ = __builtin_nan("");
  bool has_moved_ = false;
  double in_dive_m_ = 0;
  double steeply_m_ = 0;
  double highest_m_ = __builtin_nan("");  ///< the least of the depths since then
  double lowest_m_ = __builtin_nan("");   ///< the greatest
  double out_s_ = 0;                      ///< how long the vehicle has been driven up
  bool sinks_ = false;                    ///< it may be driven down
  double since_up_s_ = 0;                 ///< since it was driven up long enough to rise
  double last_m_ = __builtin_nan("");     ///< the newest depth, and its last change
  double moved_m_ = __builtin_nan("");
  double gap_s_ = __builtin_nan("");  ///< since then
  double roughness_m_ = 0;            ///< how much the depth's change varies from cycle to cycle
};

}  // namespace glider::hooks
