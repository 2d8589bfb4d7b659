// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/flight/navigator.h"

#include "simulator/geography/ddmm.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glider::simulator {
namespace {

// At a pitch nearer to level than this the speed cannot be computed from depth rate and pitch: the
// last one is kept.
constexpr double kLeastPitch = 11 * std::numbers::pi / 180;
constexpr double kMostSpeed = 0.8;   // m/s; a higher value is an inflection, not flight
constexpr double kUsualSpeed = 0.3;  // m/s, while none is known
constexpr double kMostCrab = std::numbers::pi / 3;  // against a current that is too strong

}  // namespace

double Navigator::speedFrom(double depth_rate, double pitch) const {
  const double attack = angleOfAttack(hull_, pitch);
  return -depth_rate / std::tan(pitch + (std::isnan(attack) ? 0 : attack));
}

void Navigator::reckon(double depth_rate, double pitch, double heading, bool at_surface,
                       double seconds, Planar current) {
  if (at_surface) {
    speed_ = 0;
  } else if (std::fabs(pitch) >= kLeastPitch) {
    const double speed = speedFrom(depth_rate, pitch);
    speed_ = speed >= 0 && speed <= kMostSpeed ? speed : speed_;
  }
  heading_ = std::isnan(heading) ? heading_ : heading;
  x_ += (speed_ * std::sin(heading_) + current.east) * seconds;
  y_ += (speed_ * std::cos(heading_) + current.north) * seconds;
}

double Navigator::headingFor(double bearing, Planar current) const {
  const double speed = speed_ > 0 ? speed_ : kUsualSpeed;
  const double across = current.east * std::cos(bearing) - current.north * std::sin(bearing);
  const double crab = std::asin(std::clamp(across / speed, -1.0, 1.0));
  return bearing - std::clamp(crab, -kMostCrab, kMostCrab);
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
