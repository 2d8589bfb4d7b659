// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/propeller_motion.h"

#include <array>
#include <cmath>

/// A second vehicle with a propeller, which shares no code with the simulator's: Kirchhoff's
/// equations of momentum with their cross products, the moment of Munk among them, and the drag
/// across the hull as an integral in closed form.
namespace glider::simulator {

using Triple = std::array<double, 3>;

inline Triple cross(const Triple& a, const Triple& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

class SecondPropelled {
 public:
  /// u, v, w, q, r, pitch.
  using State = std::array<double, 6>;

  explicit SecondPropelled(const platforms::PropellerMotion& motion) : m_(motion) {}

  double turns = 0, rudder = 0, stern = 0;           ///< 1/s, rad
  double turns_to = 0, rudder_to = 0, stern_to = 0;  ///< what is commanded, within the limits
  double lift = 0;                                   ///< N up

  /// The motors approach what is commanded with a lag, at most at their rates.
  void moveMotors(double dt) {
    const auto approach = [dt](double& at, double to, double lag, double rate) {
      at += dt * std::fmin(std::fmax((to - at) / lag, -rate), rate);
    };
    const auto& p = m_.propeller;
    approach(turns, turns_to, p.rpm_lag_s, p.rpm_rate_rpm_s / 60);
    approach(rudder, rudder_to, m_.fins.lag_s, m_.fins.rate_rad_s);
    approach(stern, stern_to, m_.fins.lag_s, m_.fins.rate_rad_s);
  }

  /// A velocity along the axes of the hull as one to the north, to the east and down: pitched, then
  /// turned.
  static Triple toEarth(const Triple& hull, double pitch, double heading) {
    const double level = hull[0] * std::cos(pitch) + hull[2] * std::sin(pitch);
    const double down = -hull[0] * std::sin(pitch) + hull[2] * std::cos(pitch);
    return {level * std::cos(heading) - hull[1] * std::sin(heading),
            level * std::sin(heading) + hull[1] * std::cos(heading), down};
  }

  [[nodiscard]] State rate(const State& s) const {
    const double u = s[0], v = s[1], w = s[2], q = s[3], r = s[4], pitch = s[5];
    const auto& hull = m_.hull;
    const double ahead_kg = hull.mass_kg + hull.added_surge_kg;
    const double side_kg = hull.mass_kg + hull.added_side_kg;
    const Triple velocity{u, v, w}, turning{0, q, r};
    const Triple momentum{ahead_kg * u, side_kg * v, side_kg * w};
    const Triple force_of_turning = cross(turning, momentum);
    const Triple munk = cross(velocity, momentum);
    const double weight = 9.81 * hull.mass_kg;
    Triple force{push(u) - dragAhead(u, v, w) + lift * std::sin(pitch), 0, -lift * std::cos(pitch)};
    Triple moment{0, -weight * hull.centre_of_mass_m * std::sin(pitch), 0};
    // What the hull adds to Munk's moment is what its coefficient does not have of it.
    const double munk_kg = hull.added_side_kg - hull.added_surge_kg;
    addPlane(m_.horizontal, u, v, r, rudder, munk_kg, force[1], moment[2]);
    double down = 0, nose_down = 0;
    addPlane(m_.vertical, u, w, -q, -stern, munk_kg, down, nose_down);
    force[2] += down;
    moment[1] -= nose_down;
    return {(force[0] - force_of_turning[0]) / ahead_kg, (force[1] - force_of_turning[1]) / side_kg,
            (force[2] - force_of_turning[2]) / side_kg,  (moment[1] - munk[1]) / hull.inertia_kg_m2,
            (moment[2] - munk[2]) / hull.inertia_kg_m2,  q};
  }

 private:
  [[nodiscard]] double push(double u) const {
    const auto& p = m_.propeller;
    const double free = p.static_thrust_n_s2 * turns * std::fabs(turns) -
                        p.advance_loss_n_s2_m * std::fabs(turns) * u;
    return std::fmin(std::fmax(free, -p.greatest_thrust_n), p.greatest_thrust_n);
  }

  [[nodiscard]] double dragAhead(double u, double v, double w) const {
    const double whole = std::sqrt(u * u + v * v + w * w);
    const double slow = m_.hull.surge_damping_n_s_m * std::exp(-m_.hull.creep_s_m * whole);
    const double fins = m_.horizontal.fin_force_n_s2_m2 * std::pow(rudder, 2) +
                        m_.vertical.fin_force_n_s2_m2 * std::pow(stern, 2);
    return u * slow + u * whole * (m_.hull.surge_drag_n_s2_m2 + fins);
  }

  /// The integrals of |s + x t| (s + x t) over the hull, and of x times it, by the antiderivatives
  /// of y |y| and y y |y| with y = s + x t.
  void addCrossFlow(double s, double t, double& force, double& moment) const {
    const double half = m_.hull.length_m / 2;
    const double c = 0.5 * 1026 * m_.hull.cross_flow_drag * m_.hull.diameter_m;
    if (std::fabs(t) < 1e-6) {
      force -= c * s * std::fabs(s) * 2 * half;
      moment -= c * 2 * std::fabs(s) * t * 2 * half * half * half / 3;
      return;
    }
    const double bow = s + half * t, stern_flow = s - half * t;
    const auto first = [](double y) { return std::pow(std::fabs(y), 3) / 3; };
    const auto second = [](double y) { return y * std::pow(std::fabs(y), 3) / 4; };
    const double plain = (first(bow) - first(stern_flow)) / t;
    force -= c * plain;
    moment -= c * ((second(bow) - second(stern_flow)) / t - s * plain) / t;
  }

  void addPlane(const platforms::HullPlane& p, double u, double s, double t, double fin,
                double munk_kg, double& force, double& moment) const {
    const double flow = std::sqrt(u * u + s * s);
    const double fin_push = fin * p.fin_force_n_s2_m2 * u * flow;
    force += std::fabs(u) * (p.turn_lift_n_s2_m * t - p.lift_n_s2_m2 * s) -
             s * p.side_damping_n_s_m * std::exp(-m_.hull.creep_s_m * flow) - fin_push;
    moment += u * s * (munk_kg - p.side_moment_n_s2_m) - t * p.turn_damping_nm_s -
              std::fabs(u) * t * p.turn_moment_n_s2 + fin_push * p.fin_arm_m;
    addCrossFlow(s, t, force, moment);
  }

  const platforms::PropellerMotion& m_;
};

}  // namespace glider::simulator
