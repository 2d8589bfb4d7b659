// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/vehicle/propeller_forces.h"

#include "simulator/vehicle/flight_model.h"

#include <algorithm>
#include <cmath>

namespace glider::simulator {
namespace {

constexpr double kWater = 1026;  ///< kg/m3: of the published coefficients
constexpr int kStrips = 20;

}  // namespace

double thrust(const platforms::Propeller& propeller, double turns_per_s, double surge) {
  const double free = std::fabs(turns_per_s) * (propeller.static_thrust_n_s2 * turns_per_s -
                                                propeller.advance_loss_n_s2_m * surge);
  return std::clamp(free, -propeller.greatest_thrust_n, propeller.greatest_thrust_n);
}

SideForce crossFlow(const platforms::Hull& hull, double side, double turn) {
  const double strip_m = hull.length_m / kStrips;
  const double per_flow = 0.5 * kWater * hull.cross_flow_drag * hull.diameter_m * strip_m;
  SideForce sum;
  for (int i = 0; i < kStrips; ++i) {
    const double x = (i + 0.5) * strip_m - 0.5 * hull.length_m;
    const double flow = side + x * turn;
    const double force = -per_flow * std::fabs(flow) * flow;
    sum.force += force;
    sum.moment += x * force;
  }
  return sum;
}

SideForce sideForce(const platforms::Hull& hull, const platforms::HullPlane& plane, double ahead,
                    double side, double turn, double fin) {
  const double speed = std::hypot(ahead, side);
  const double creep = std::exp(-hull.creep_s_m * speed);
  SideForce sum = crossFlow(hull, side, turn);
  sum.force += -plane.side_damping_n_s_m * creep * side -
               plane.lift_n_s2_m2 * std::fabs(ahead) * side +
               plane.turn_lift_n_s2_m * std::fabs(ahead) * turn;
  sum.moment += -plane.turn_damping_nm_s * turn - plane.side_moment_n_s2_m * ahead * side -
                plane.turn_moment_n_s2 * std::fabs(ahead) * turn;
  // The fin is at the stern: it pushes the stern to one side to turn the bow to the other.
  const double push = plane.fin_force_n_s2_m2 * fin * ahead * speed;
  sum.force -= push;
  sum.moment += push * plane.fin_arm_m;
  return sum;
}

BodyVelocity acceleration(const platforms::PropellerMotion& vehicle, const BodyVelocity& v,
                          double pitch_rad, const HullControls& controls) {
  const platforms::Hull& hull = vehicle.hull;
  const double surge_kg = hull.mass_kg + hull.added_surge_kg;
  const double side_kg = hull.mass_kg + hull.added_side_kg;
  const double weight = hull.mass_kg * kGravity;
  // The vertical plane is the horizontal one laid on its side: heave is down, pitch nose up.
  const SideForce across =
      sideForce(hull, vehicle.horizontal, v.surge, v.sway, v.yaw, controls.rudder_rad);
  const SideForce down =
      sideForce(hull, vehicle.vertical, v.surge, v.heave, -v.pitch, -controls.stern_plane_rad);
  const double speed = std::hypot(v.surge, v.sway, v.heave);
  const double fins_drag =
      vehicle.horizontal.fin_force_n_s2_m2 * controls.rudder_rad * controls.rudder_rad +
      vehicle.vertical.fin_force_n_s2_m2 * controls.stern_plane_rad * controls.stern_plane_rad;
  const double drag = (hull.surge_damping_n_s_m * std::exp(-hull.creep_s_m * speed) +
                       (hull.surge_drag_n_s2_m2 + fins_drag) * speed) *
                      v.surge;
  BodyVelocity rate;
  rate.surge =
      (thrust(vehicle.propeller, controls.turns_per_s, v.surge) - drag +
       controls.net_lift_n * std::sin(pitch_rad) + side_kg * (v.sway * v.yaw - v.heave * v.pitch)) /
      surge_kg;
  rate.sway = (across.force - surge_kg * v.surge * v.yaw) / side_kg;
  rate.heave =
      (down.force + surge_kg * v.surge * v.pitch - controls.net_lift_n * std::cos(pitch_rad)) /
      side_kg;
  rate.yaw = across.moment / hull.inertia_kg_m2;
  rate.pitch =
      (-down.moment - hull.centre_of_mass_m * weight * std::sin(pitch_rad)) / hull.inertia_kg_m2;
  return rate;
}

}  // namespace glider::simulator
