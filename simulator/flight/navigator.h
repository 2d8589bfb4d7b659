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
  explicit Navigator(const LocalFrame& frame) : frame_(frame) {}

  /// One control cycle of `seconds` on a true heading. A NaN is replaced by the last known value.
  void reckon(double depth_rate, double pitch, double heading, bool at_surface, double seconds);
  void fix(Gps::Fix fix) { x_ = fix.x, y_ = fix.y; }

  [[nodiscard]] double x() const { return x_; }
  [[nodiscard]] double y() const { return y_; }
  [[nodiscard]] double speed() const { return speed_; }  ///< horizontal, through the water
  [[nodiscard]] GeoPosition position() const { return frame_.position(x_, y_); }
  /// Distance and true bearing (0…2 pi) from the position by dead reckoning to a waypoint in
  /// ddmm.mmmm.
  void toWaypoint(double latitude_ddmm, double longitude_ddmm, double& distance,
                  double& bearing) const;

 private:
  const LocalFrame& frame_;
  double x_ = 0, y_ = 0, speed_ = 0, heading_ = 0;
};

}  // namespace glider::simulator
