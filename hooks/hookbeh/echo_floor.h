// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/bottom_memory.h"

namespace glider::hooks {

/// How deep the bottom is at least, by the altimeter's echoes. While it receives none, the bottom
/// may rise as it did between the last echoes, and more; on the other hand an altimeter that would
/// have received an echo of a near bottom shows that there is none. How soon silence shows that
/// depends on how often it receives echoes.
class EchoFloor {
 public:
  /// Takes in one cycle. `depth_m`: NaN while it is not believed. `least_m`: an old echo at the
  /// surface may keep the floor as high as this, m.
  void observe(double depth_m, double altitude_m, double least_m, double step_s);
  /// What the sensor array held before hookbeh began: an echo of an earlier time.
  void ignore(double altitude_m) { seen_m_ = altitude_m; }
  /// An echo came in this cycle.
  [[nodiscard]] bool heard() const { return heard_; }
  /// The bottom's depth by the newest echo, m; NaN before the first.
  [[nodiscard]] double bottom() const { return bottom_m_; }
  /// Since the newest echo, s; NaN before the first.
  [[nodiscard]] double silence() const { return silent_s_; }
  /// The least depth of the bottom now, m.
  [[nodiscard]] double floor() const { return floor_m_; }
  /// It received many echoes, in most cycles, and then fell silent well within its range, or while
  /// the vehicle sank towards the bottom: it has probably failed. Fewer may have been fish.
  [[nodiscard]] bool hasFailed() const;

 private:
  void hear(double depth_m, double altitude_m);
  void learnRise(double bottom_m);
  void wait(double depth_m, double least_m, double step_s);
  void listen(double depth_m);
  [[nodiscard]] double beyond(double depth_m) const;

  bool heard_ = false;
  double seen_m_ = __builtin_nan("");      ///< the altitude in the sensor array
  double altitude_m_ = __builtin_nan("");  ///< that of the newest echo
  double bottom_m_ = __builtin_nan("");
  double floor_m_ = kBottomless;
  double silent_s_ = __builtin_nan("");
  double heard_at_m_ = __builtin_nan("");  ///< depth of the vehicle then
  bool sank_ = false;                      ///< the vehicle sank when the echoes ended
  double echoes_ = 0;                      ///< since silence last ruled out a bottom
  double missed_ = 0;    ///< cycles since the newest echo in which there should have been one
  double listened_ = 0;  ///< cycles without an echo at depths from this one on
  double least_m_ = 0;
  double cleared_m_ = kBottomless;       ///< silence ruled out a bottom above this depth
  double gap_ = 20;                      ///< how many there are from echo to echo, on average
  double reach_m_ = 20;                  ///< from how far an echo has come
  double rise_mps_ = 0.06;               ///< how fast the bottom has risen
  double anchor_m_ = __builtin_nan("");  ///< an earlier echo, and its age
  double anchor_s_ = __builtin_nan("");
};

}  // namespace glider::hooks
