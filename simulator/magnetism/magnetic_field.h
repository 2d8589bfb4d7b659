// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::simulator {

/// The Earth's magnetic field at a place and time.
struct MagneticField {
  double horizontal_nT = 0;
  double inclination_rad = 0;  ///< down positive
  double declination_rad = 0;  ///< of magnetic north from true north, east positive
};

/// The years for which the model holds.
inline constexpr double kFirstMagneticYear = 2025;
inline constexpr double kLastMagneticYear = 2030;

/// The field of the World Magnetic Model 2025 (NOAA/NCEI) at a geodetic position on WGS 84,
/// degrees, north and east positive, `height_km` above the ellipsoid, in a year with its fraction:
/// 2026.5 is the middle of 2026. Formulas: the spherical-harmonic synthesis of the model's
/// technical report, sections 1.2 and 1.3.
MagneticField magneticField(double latitude_deg, double longitude_deg, double height_km,
                            double year);

}  // namespace glider::simulator
