// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"

/// The steady flight of a buoyancy glider: Merckelbach et al. 2019, J. Atmos. Oceanic Technol. 36,
/// 281-296, doi 10.1175/JTECH-D-18-0168.1. Signs: z up, pitch nose up, angle of attack with the
/// sign of the pitch.
namespace glider::simulator {

inline constexpr double kGravity = 9.81;  ///< m/s2, as in the source

using platforms::FlightCoefficients;

/// Below this pitch (magnitude) there is no attached glide: the source's model ends between 9 and
/// 11 degrees.
inline constexpr double kStallPitch = 11 * 3.14159265358979323846 / 180;

/// Net upward force (N) in water of `density` (kg/m3) at gauge pressure `pressure` (Pa) with
/// `pumped` (m3) of buoyancy volume.
double netBuoyancy(const FlightCoefficients& c, double density, double pressure_pa,
                   double pumped_m3);

/// Angle of attack (rad) of a glide at `pitch` (rad): the smallest root of the force balance. NaN
/// where there is none.
double angleOfAttack(const FlightCoefficients& c, double pitch);

/// A steady flight through the water.
struct SteadyFlight {
  double attack = 0;      ///< rad
  double speed = 0;       ///< m/s along the path
  double horizontal = 0;  ///< m/s ahead
  double vertical = 0;    ///< m/s up
  bool stalled = false;   ///< pitch too shallow, or against the buoyancy: sinks or rises broadside
};

/// The flight that balances the net force `buoyancy` (N up) at `pitch` in water of `density`.
SteadyFlight steadyFlight(const FlightCoefficients& c, double pitch, double buoyancy,
                          double density);

}  // namespace glider::simulator
