// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/flight/navigator.h"

#include "simulator/flight/position.h"

#include <cmath>
#include <numbers>

namespace glider::simulator {
namespace {

// At a pitch nearer to level than this the speed cannot be computed from depth rate and pitch: the
// last one is kept.
constexpr double kLeastPitch = 11 * std::numbers::pi / 180;
constexpr double kMostSpeed = 0.8;  // m/s; a higher value is an inflection, not flight

}  // namespace

void Navigator::reckon(double depth_rate, double pitch, double heading, bool at_surface,
                       double seconds) {
  if (at_surface) {
    speed_ = 0;
  } else if (std::fabs(pitch) >= kLeastPitch) {
    const double speed = -depth_rate / std::tan(pitch);
    speed_ = speed >= 0 && speed <= kMostSpeed ? speed : speed_;
  }
  heading_ = std::isnan(heading) ? heading_ : heading;
  x_ += speed_ * std::sin(heading_) * seconds;
  y_ += speed_ * std::cos(heading_) * seconds;
}

void Navigator::toWaypoint(double latitude_ddmm, double longitude_ddmm, double& distance,
                           double& bearing) const {
  double x = 0, y = 0;
  frame_.locate({fromDdmm(latitude_ddmm), fromDdmm(longitude_ddmm)}, x, y);
  distance = std::hypot(x - x_, y - y_);
  const double angle = std::atan2(x - x_, y - y_);
  bearing = angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

}  // namespace glider::simulator
