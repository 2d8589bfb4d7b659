// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/position.h"

#include <stdint.h>

namespace glider::hooks {

/// A depth that counts as no bottom at all, m.
inline constexpr double kBottomless = 1e9;
/// False for a floor at no depth that any sea has.
inline bool isKnown(double floor_m) {
  return floor_m < kBottomless / 2;
}

/// How steeply the bottom rises from one place and depth to another, m per m: 0 if it falls, or if
/// the places are too near to each other to tell.
double riseBetween(const Position& from, double from_m, const Position& to, double to_m);

/// Places where the bottom is known although the altimeter did not show it: where the vehicle
/// touched it, and where an altimeter that then failed received its last echo. Memory fades with
/// the distance from the place, not with time: the bottom does not move.
class BottomMemory {
 public:
  /// Takes in one cycle: where the vehicle is now.
  void observe(const Position& now, double step_s);
  /// The bottom is at `depth_m` at `at`. It rises by `rise` metres a metre towards other places, as
  /// far as is known. `touched`: the vehicle has been there.
  void add(const Position& at, double depth_m, double rise, bool touched);
  /// The altimeter works: places where the vehicle has not been are forgotten.
  void forgetEchoes();
  /// How deep the bottom is at least where the vehicle is now, m.
  [[nodiscard]] double floor() const;
  /// How deep it was at the nearest place that the vehicle has touched, m; NaN if none is within
  /// 500 m.
  [[nodiscard]] double touchedHere() const;
  /// How steeply it rises from the touched places within 3 km to `depth_m` at `at`, m per m.
  [[nodiscard]] double riseTo(const Position& at, double depth_m) const;

 private:
  struct Place {
    Position at;
    double depth_m = kBottomless;
    double rise = 0;
    double age_s = 0;
    double distance_m = 0;  ///< from the vehicle, now
    bool touched = false;
  };
  [[nodiscard]] Place& placeFor(const Position& at);

  static constexpr uint8_t kCount = 8;
  Place places_[kCount];
};

}  // namespace glider::hooks
