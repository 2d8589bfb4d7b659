// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/geography/planar.h"

#include <cmath>

namespace glider::simulator {

/// Where a vehicle takes itself to be: the last fix and its way through the water since. It does
/// not know the current.
class DeadReckoning {
 public:
  void startAt(const Planar& place) { start_ = place_ = place; }
  void fix(const Planar& place) { place_ = place; }
  /// `ahead_mps`: horizontally, towards `heading`, rad clockwise from true north.
  void advance(double ahead_mps, double heading, double seconds) {
    place_.east += ahead_mps * std::sin(heading) * seconds;
    place_.north += ahead_mps * std::cos(heading) * seconds;
  }
  [[nodiscard]] const Planar& place() const { return place_; }
  /// The same from where it started.
  [[nodiscard]] Planar sinceStart() const {
    return {place_.east - start_.east, place_.north - start_.north};
  }

 private:
  Planar start_;
  Planar place_;
};

}  // namespace glider::simulator
