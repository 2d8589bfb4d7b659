// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/geography/local_frame.h"
#include "simulator/sensors/gps/gps.h"
#include "simulator/slocum/flight/current_estimate.h"
#include "simulator/vehicle/flight_model.h"

#include <optional>

namespace glider::simulator {

/// Dead reckoning: horizontal speed from depth rate and pitch, computed as in the vehicle; a GPS
/// fix corrects it.
class Navigator {
 public:
  /// It starts at the origin of `frame`. The angle of attack is that of a steady flight of `hull`;
  /// 0 for one without lift.
  explicit Navigator(const LocalFrame& frame, const FlightCoefficients& hull = {})
      : frame_(frame), hull_(hull) {}
  /// It starts at (x, y) of the frame instead.
  void startAt(double x, double y) { x_ = start_x_ = x, y_ = start_y_ = y; }

  /// One control cycle of `seconds` on a true heading in water that moves by `current`. A NaN is
  /// replaced by the last known value.
  void reckon(double depth_rate, double pitch, double heading, bool at_surface, double seconds,
              Planar current = {});
  void fix(Gps::Fix fix) { x_ = fix.x, y_ = fix.y; }

  /// In the frame.
  [[nodiscard]] Planar at() const { return {x_, y_}; }
  [[nodiscard]] double eastOfStart() const { return x_ - start_x_; }
  [[nodiscard]] double northOfStart() const { return y_ - start_y_; }
  [[nodiscard]] double speed() const { return speed_; }  ///< horizontal, through the water
  [[nodiscard]] GeoPosition position() const { return frame_.position(x_, y_); }
  /// Distance and true bearing (0…2 pi) from the position by dead reckoning to a waypoint in
  /// ddmm.mmmm.
  void toWaypoint(double latitude_ddmm, double longitude_ddmm, double& distance,
                  double& bearing) const;
  /// The true heading on which the vehicle travels along `bearing` in that current.
  [[nodiscard]] double headingFor(double bearing, Planar current) const;

 private:
  [[nodiscard]] double speedFrom(double depth_rate, double pitch) const;

  const LocalFrame& frame_;
  FlightCoefficients hull_;
  double start_x_ = 0, start_y_ = 0;
  double x_ = 0, y_ = 0, speed_ = 0, heading_ = 0;
};

}  // namespace glider::simulator
