// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <vector>

/// The numbers of a vehicle with one propeller, a rudder and stern planes. The simulator's
/// propeller_forces.h has the formulas. Plain SI units, turns of the propeller in revolutions per
/// minute (rpm) or per second.
namespace glider::platforms {

/// Thrust = static_thrust |n| n - advance_loss |n| u, n in 1/s and u, the speed ahead, in m/s.
struct Propeller {
  double greatest_rpm = 0;  ///< ahead; it does not turn astern
  double rpm_lag_s = 0;
  double rpm_rate_rpm_s = 0;  ///< the fastest change
  double static_thrust_n_s2 = 0;
  double advance_loss_n_s2_m = 0;
  double greatest_thrust_n = 0;
};

/// Rudder and stern planes. Positive turns to starboard, and raises the nose.
struct Fins {
  double rudder_rad = 0;       ///< how far it moves to either side
  double stern_plane_rad = 0;  ///< the same
  double lag_s = 0;
  double rate_rad_s = 0;
};

struct Hull {
  double mass_kg = 0;
  double positive_buoyancy_kg = 0;  ///< of water displaced more than it weighs
  double length_m = 0;
  double diameter_m = 0;
  double centre_of_mass_m = 0;  ///< below the centre of buoyancy
  double inertia_kg_m2 = 0;     ///< of pitch and yaw, with that of the water moved along
  double added_surge_kg = 0;    ///< mass of the water moved along
  double added_side_kg = 0;     ///< the same in sway and heave
  double surge_damping_n_s_m = 0;
  double surge_drag_n_s2_m2 = 0;
  double creep_s_m = 0;        ///< the linear damping of a speed U fades as exp(-creep_s_m U)
  double cross_flow_drag = 0;  ///< drag coefficient of a cylinder across the flow
};

/// Forces and moments in one plane: horizontal (sway, yaw, rudder) or vertical (heave, pitch, stern
/// planes). Each is that against a sideways speed s or a rate of turn t, alone or times the speed
/// ahead u.
struct HullPlane {
  double side_damping_n_s_m = 0;  ///< force by s; it fades by creep_s_m
  double turn_damping_nm_s = 0;   ///< moment by t
  double lift_n_s2_m2 = 0;        ///< force by u s
  double turn_lift_n_s2_m = 0;    ///< force by u t, to the side of the turn
  double side_moment_n_s2_m = 0;  ///< moment by u s: that of Munk less what fins and lift restore
  double turn_moment_n_s2 = 0;    ///< moment by u t
  double fin_force_n_s2_m2 = 0;   ///< by the fin's angle (rad) and u U
  double fin_arm_m = 0;           ///< of the fin behind the centre
};

/// How a vehicle with a propeller moves.
struct PropellerMotion {
  Propeller propeller;
  Fins fins;
  Hull hull;
  HullPlane horizontal;
  HullPlane vertical;
};

/// The electrical power of a propeller: straight lines between the points of a table.
struct PropellerPower {
  std::vector<double> rpm;  ///< increasing, from 0 to the greatest
  std::vector<double> watt;
};

}  // namespace glider::platforms
