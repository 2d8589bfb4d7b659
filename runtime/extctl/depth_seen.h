// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::runtime::extctl {

/// How deep the water is known to be: as deep as the vehicle has just been. Not every vehicle has
/// an altimeter, and none reports an altitude in every cycle.
class DepthSeen {
 public:
  /// What it was more than `forget_m` below the vehicle says nothing about the water here.
  explicit DepthSeen(double forget_m) : forget_m_(forget_m) {}

  /// The vehicle is at `depth_m`, m; NaN, which is unknown, changes nothing.
  void look(double depth_m);
  /// The vehicle has just been so deep, m: now, or where its last dive ended. At the surface, where
  /// it may drift for hours, nothing is known: 0.
  [[nodiscard]] double deep() const { return deep_m_; }

 private:
  void turn(double depth_m);

  double forget_m_;
  double deep_m_ = 0;
  double extreme_m_ = 0;  ///< since the last turn
  bool climbs_ = true;
};

}  // namespace glider::runtime::extctl
