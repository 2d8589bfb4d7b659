// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/cadence.h"
#include "hooks/hookbeh/command.h"
#include "hooks/hookbeh/hull.h"
#include "hooks/hookbeh/trend.h"

#include <stdint.h>

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
  /// How much farther than in calm water and with a reading every 4 s the vehicle may sink before
  /// its depth can show it, m: swell hides its motion for a while, and so do rare readings.
  [[nodiscard]] double lateBy() const;
  /// How far it may have sunk since its depth last answered: since it moved as far as the vehicle
  /// was driven by pitch and pump. No other sensor counts here, since both may be stuck. m.
  [[nodiscard]] double unanswered() const { return unanswered_m_; }
  /// The depth that answered, or 0 once the vehicle must be at the surface, m.
  [[nodiscard]] double answered() const { return answered_m_; }
  /// How long it has been driven up, s.
  [[nodiscard]] double drivenUpFor() const { return out_s_; }

 private:
  /// The fastest the vehicle sinks, m/s: at its steepest pitch, or at this one.
  [[nodiscard]] double steepestRate() const;
  [[nodiscard]] double rateAt(double pitch_rad) const;
  void reckon(double step_s, const VerticalCommand& last);
  void reckonUnanswered(double sunk_m, double risen_m);
  void turn(bool lifts, bool dives);
  void follow(double depth_m);
  void restartAt(double depth_m);
  void seek(double depth_m);
  [[nodiscard]] bool hasMovedDown(double depth_m, double trend_m) const;
  [[nodiscard]] bool hasMovedUp(double depth_m, double trend_m) const;
  [[nodiscard]] bool hasAnswered(double depth_m, double trend_m) const;
  void show(double depth_m);

  Hull hull_;
  Cadence cadence_;
  Trend trend_;
  double deepest_m_ = __builtin_nan("");
  double shown_m_ = __builtin_nan("");
  bool has_moved_ = false;
  double in_dive_m_ = 0;
  double steeply_m_ = 0;
  double highest_m_ = __builtin_nan("");  ///< the least of the depths since then
  double lowest_m_ = __builtin_nan("");   ///< the greatest
  double out_s_ = 0;                      ///< how long the vehicle has been driven up
  bool sinks_ = false;                    ///< it may be driven down
  double masked_s_ = 0;                   ///< how long another behaviour has commanded it
  double since_up_s_ = 0;                 ///< since it was driven up long enough to rise
  double last_m_ = __builtin_nan("");  ///< the newest reading, and its change from the one before
  double moved_m_ = __builtin_nan("");
  double gap_s_ = __builtin_nan("");  ///< and the time from that one to it
  double roughness_m_ = 0;  ///< how far readings are off the line between their neighbours
  bool lifts_ = false;      ///< it is driven up by pitch and pump
  bool dives_ = false;      ///< it is driven down by pitch
  uint8_t turning_ = 0;     ///< so many further readings may be off the line for that
  double turned_m_ = __builtin_nan("");  ///< the extreme since it was first driven so
  double dived_m_ = __builtin_nan("");   ///< the depth that last showed this dive
  double alone_m_ = __builtin_nan("");   ///< as deepest_m_, by answers alone
  double answered_m_ = 0;
  double unanswered_m_ = 0;
};

}  // namespace glider::hooks
