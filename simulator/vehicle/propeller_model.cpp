// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/vehicle/propeller_model.h"

#include "simulator/vehicle/flight_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace glider::simulator {
namespace {

// The quickest motion is that of the rate of turn: it takes 0.2 s.
constexpr int kSubsteps = 10;
constexpr double kSubstep = VehicleModel::kStep / kSubsteps;
constexpr double kSecondsPerMinute = 60;
constexpr double kTurn = 2 * std::numbers::pi;
// The hull does not loop: the equations hold for an upright one.
constexpr double kSteepest = 80 * std::numbers::pi / 180;
// A heavy hull on the bottom loses its way within some seconds.
constexpr double kFrictionLag_s = 2;
constexpr double kLevelLag_s = 1;

/// What a substep integrates.
struct Path {
  BodyVelocity velocity;
  double pitch = 0, heading = 0;
  double east = 0, north = 0, down = 0;
};

Path moved(const Path& from, const Path& rate, double seconds) {
  const auto add = [seconds](double value, double change) { return value + change * seconds; };
  const BodyVelocity &v = from.velocity, &a = rate.velocity;
  return {{add(v.surge, a.surge), add(v.sway, a.sway), add(v.heave, a.heave), add(v.pitch, a.pitch),
           add(v.yaw, a.yaw)},
          std::clamp(add(from.pitch, rate.pitch), -kSteepest, kSteepest),
          add(from.heading, rate.heading),
          add(from.east, rate.east),
          add(from.north, rate.north),
          add(from.down, rate.down)};
}

double ahead(const BodyVelocity& v, double pitch) {
  return v.surge * std::cos(pitch) + v.heave * std::sin(pitch);
}

double down(const BodyVelocity& v, double pitch) {
  return v.heave * std::cos(pitch) - v.surge * std::sin(pitch);
}

/// Removes the vertical part of a velocity.
void level(BodyVelocity& v, double pitch) {
  const double along = ahead(v, pitch);
  v.surge = along * std::cos(pitch);
  v.heave = along * std::sin(pitch);
}

/// Between the surface and the bottom, where the hull stops. On the bottom the ground under its
/// nose levels it, or the propeller would hold it there.
void limitDepth(Path& path, double water_depth_m, double seconds) {
  const double sinks = down(path.velocity, path.pitch);
  if ((path.down <= 0 && sinks < 0) || (path.down >= water_depth_m && sinks > 0)) {
    level(path.velocity, path.pitch);
  }
  if (path.down >= water_depth_m && path.pitch < 0) {
    path.pitch *= std::exp(-seconds / kLevelLag_s);
    path.velocity.pitch = std::max(path.velocity.pitch, 0.0);
  }
  path.down = std::clamp(path.down, 0.0, std::max(water_depth_m, 0.0));
}

}  // namespace

PropellerModel::PropellerModel(const platforms::PropellerMotion& motion,
                               const VehicleSettings& settings)
    : motion_(motion),
      settings_(settings),
      volume_m3_(settings.flight.hull_volume_m3 *
                 (1 + settings.positive_buoyancy_kg / motion.hull.mass_kg)) {}

VehicleState PropellerModel::start() const {
  const platforms::Hull& hull = motion_.hull;
  const platforms::Fins& fins = motion_.fins;
  VehicleState state;
  state.x_m = settings_.start_x_m;
  state.y_m = settings_.start_y_m;
  state.heading_rad = settings_.initial_heading_rad;
  const double immersed = hull.mass_kg / (hull.mass_kg + settings_.positive_buoyancy_kg);
  state.depth_m = std::max(0.0, (immersed - 0.5) * hull.diameter_m);
  state.rpm = {0,
               0,
               motion_.propeller.rpm_rate_rpm_s,
               0,
               motion_.propeller.greatest_rpm,
               motion_.propeller.rpm_lag_s};
  state.fin = {0, 0, fins.rate_rad_s, -fins.rudder_rad, fins.rudder_rad, fins.lag_s};
  state.stern_plane = {0,         0, fins.rate_rad_s, -fins.stern_plane_rad, fins.stern_plane_rad,
                       fins.lag_s};
  return state;
}

void PropellerModel::moveMotors(VehicleState& s, double seconds) const {
  s.rpm.step(seconds);
  s.fin.step(seconds);
  s.stern_plane.step(seconds);
}

double PropellerModel::netLift(double depth_m, double density) const {
  // `depth_m` is that of the middle of the hull, which is half under water at 0. Straight between
  // the ends: the hull's section is round, so this is wrong by at most a tenth of its volume.
  const double immersed = std::clamp(0.5 + depth_m / motion_.hull.diameter_m, 0.0, 1.0);
  return kGravity * (density * volume_m3_ * immersed - motion_.hull.mass_kg);
}

bool PropellerModel::aground(const VehicleState& s, const Water& water) const {
  return s.depth_m > 0 && s.depth_m >= water.depth_m && netLift(s.depth_m, water.density) < 0;
}

void PropellerModel::moveHull(VehicleState& s, const Water& water, double seconds) const {
  const bool lies = aground(s, water);
  const Planar current = lies ? Planar{} : water.current;
  const HullControls controls{s.rpm.position / kSecondsPerMinute, s.fin.position,
                              s.stern_plane.position, 0};
  const auto rateOf = [&](const Path& path) {
    HullControls now = controls;
    now.net_lift_n = netLift(path.down, water.density);
    const BodyVelocity& v = path.velocity;
    const double along = ahead(v, path.pitch);
    const double north = std::cos(path.heading), east = std::sin(path.heading);
    return Path{acceleration(motion_, v, path.pitch, now),
                v.pitch,
                v.yaw / std::cos(path.pitch),
                along * east + v.sway * north + current.east,
                along * north - v.sway * east + current.north,
                down(v, path.pitch) - (lies ? 0 : water.rises_mps)};
  };
  // The midpoint method: second order.
  const Path from{s.body, s.pitch_rad, s.heading_rad, s.x_m, s.y_m, s.depth_m};
  Path to = moved(from, rateOf(moved(from, rateOf(from), seconds / 2)), seconds);
  if (std::fabs(to.pitch) >= kSteepest) {
    to.velocity.pitch = 0;
  }
  limitDepth(to, water.depth_m, seconds);
  if (lies) {
    const double kept = std::exp(-seconds / kFrictionLag_s);
    to.velocity.surge *= kept;
    to.velocity.sway *= kept;
    to.velocity.yaw *= kept;
  }
  s.body = to.velocity;
  s.pitch_rad = to.pitch;
  s.heading_rad = to.heading - kTurn * std::floor(to.heading / kTurn);
  s.x_m = to.east;
  s.y_m = to.north;
  s.depth_m = to.down;
}

void PropellerModel::step(VehicleState& s, const VehicleCommand& command, const Ocean& ocean,
                          double now_s) const {
  s.rpm.target = command.rpm;
  s.fin.target = command.fin_rad;
  s.stern_plane.target = command.stern_plane_rad;
  const Water water{ocean.density(s.depth_m, s.x_m, s.y_m, now_s), ocean.waterDepth(s.x_m, s.y_m),
                    ocean.current(s.depth_m, s.x_m, s.y_m),
                    ocean.verticalCurrent(s.depth_m, s.x_m, s.y_m, now_s)};
  for (int i = 0; i < kSubsteps; ++i) {
    moveMotors(s, kSubstep);
    moveHull(s, water, kSubstep);
  }
  // The bottom where the vehicle has come to may be shallower.
  s.depth_m = std::clamp(s.depth_m, 0.0, std::max(0.0, ocean.waterDepth(s.x_m, s.y_m)));
  s.ahead_mps = ahead(s.body, s.pitch_rad);
  s.up_mps = -down(s.body, s.pitch_rad);
  s.turn_rate_rad_s = s.body.yaw / std::cos(s.pitch_rad);
}

}  // namespace glider::simulator
