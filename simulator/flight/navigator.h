// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/geography/local_frame.h"
#include "simulator/sensors/gps/gps.h"

#include <optional>

namespace glider::simulator {

/// Dead reckoning: horizontal speed from depth rate and pitch, computed as in the vehicle, with an
/// angle of attack of 0; a GPS fix corrects it.
class Navigator {
 public:
  /// It starts at the origin of `frame`.
  explicit Navigator(const LocalFrame& frame) : frame_(frame) {}
  /// It starts at (x, y) of the frame instead.
  void startAt(double x, double y) { x_ = start_x_ = x, y_ = start_y_ = y; }

  /// One control cycle of `seconds` on a true heading. A NaN is replaced by the last known value.
  void reckon(double depth_rate, double pitch, double heading, bool at_surface, double seconds);
  void fix(Gps::Fix fix) { x_ = fix.x, y_ = fix.y; }

  [[nodiscard]] double eastOfStart() const { return x_ - start_x_; }
  [[nodiscard]] double northOfStart() const { return y_ - start_y_; }
  [[nodiscard]] double speed() const { return speed_; }  ///< horizontal, through the water
  [[nodiscard]] GeoPosition position() const { return frame_.position(x_, y_); }
  /// Distance and true bearing (0…2 pi) from the position by dead reckoning to a waypoint in
  /// ddmm.mmmm.
  void toWaypoint(double latitude_ddmm, double longitude_ddmm, double& distance,
                  double& bearing) const;

 private:
  const LocalFrame& frame_;
  double start_x_ = 0, start_y_ = 0;
  double x_ = 0, y_ = 0, speed_ = 0, heading_ = 0;
};

}  // namespace glider::simulator
