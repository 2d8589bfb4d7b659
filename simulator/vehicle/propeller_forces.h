// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/propeller_motion.h"
#include "simulator/vehicle/body_velocity.h"

/// The forces on a hull with a propeller, a rudder and stern planes, in five degrees of freedom:
/// Fossen, Handbook of Marine Craft Hydrodynamics and Motion Control (2011), chapters 6 to 8, and
/// Prestero, Verification of a Six-Degree of Freedom Simulation Model for the REMUS AUV (MIT,
/// 2001). Roll is left out: the weight below the centre of buoyancy keeps it within 3 degrees. The
/// origin is the centre of buoyancy; the offset of the mass counts only where it rights the hull.
namespace glider::simulator {

/// What else moves the hull than its own motion.
struct HullControls {
  double turns_per_s = 0;      ///< of the propeller
  double rudder_rad = 0;       ///< positive turns to starboard
  double stern_plane_rad = 0;  ///< positive raises the nose
  double net_lift_n = 0;       ///< buoyancy less weight
};

/// Thrust (N) at a speed ahead (m/s): straight in the advance ratio (Fossen 2011, 9.1), at most as
/// great as the motor can drive.
double thrust(const platforms::Propeller& propeller, double turns_per_s, double surge);

/// A force to the side (N) and the moment (N m) that turns to that side.
struct SideForce {
  double force = 0, moment = 0;
};

/// Those in one plane, without the masses: `side` is the speed to a side and `turn` the rate of
/// turning to it, `ahead` the speed ahead, `fin` the angle that turns to it.
SideForce sideForce(const platforms::Hull& hull, const platforms::HullPlane& plane, double ahead,
                    double side, double turn, double fin);

/// The drag of the water across a long hull, by strips (Fossen 2011, 6.4).
SideForce crossFlow(const platforms::Hull& hull, double side, double turn);

/// How fast the velocity changes: for each axis the forces over mass and added mass.
BodyVelocity acceleration(const platforms::PropellerMotion& vehicle, const BodyVelocity& velocity,
                          double pitch_rad, const HullControls& controls);

}  // namespace glider::simulator
