// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/position.h"

#include <stdint.h>

namespace glider::hooks {

/// m; over a bottom as shallow as this no vehicle can dive, for any least altitude.
inline constexpr double kShallowM = 12;
/// A depth that counts as no bottom at all, m.
inline constexpr double kBottomless = 1e9;
/// False for a floor at no depth that any sea has.
inline bool isKnown(double floor_m) {
  return floor_m < kBottomless / 2;
}

/// Places where the bottom is known although the altimeter did not show it: where the vehicle
/// touched it, and where an altimeter that then failed received its last echo. Memory fades with
/// the distance from the place, not with time: the bottom does not move.
class BottomMemory {
 public:
  /// Takes in one cycle: where the vehicle is now. All else concerns this position. Over a touched
  /// bottom of less than `shallow_m` it cannot dive, and so not fly away either: after half an hour
  /// it tries again.
  void observe(const Position& now, double shallow_m, double step_s);
  /// A dive has turned that went as deep as `depth_m`.
  void noteDive(double depth_m);
  /// The vehicle has touched the bottom at `depth_m`. Where the dive before went deeper, or the
  /// bottom was deeper at a touched place, it rises on.
  void touch(double depth_m);
  /// An altimeter has failed whose last echo showed the bottom at `depth_m`.
  void keepEcho(double depth_m);
  /// The altimeter works: what keepEcho() was given is forgotten.
  void forgetEchoes();
  /// How deep the bottom is at least, m; by the touched places alone, or by all.
  [[nodiscard]] double touchedFloor() const { return floor(true); }
  [[nodiscard]] double floor() const { return floor(false); }
  /// How deep it was at the nearest place that the vehicle has touched, m; NaN if none is within
  /// 500 m.
  [[nodiscard]] double touchedHere() const;

 private:
  struct Place {
    Position at;
    double depth_m = kBottomless;
    double rise = 0;  ///< m per m, towards other places
    double age_s = 0;
    double distance_m = 0;  ///< from the vehicle, now
    bool touched = false;
    [[nodiscard]] bool empty() const { return !isKnown(depth_m); }
    [[nodiscard]] double riseTo(double other_m) const;
  };
  [[nodiscard]] Place& placeHere(bool touched);
  void add(double depth_m, double rise, bool touched);
  [[nodiscard]] double floor(bool touched) const;

  static constexpr uint8_t kCount = 8;
  Place places_[kCount];
  Place dive_;  ///< how deep the dive before the newest went, and where
  Position here_;
};

}  // namespace glider::hooks
