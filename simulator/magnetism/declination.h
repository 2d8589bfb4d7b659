// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::simulator {

/// The declination along the path of a vehicle. A glider moves little between two control cycles,
/// so the model is computed again only where the declination may have changed by more than
/// kErrorRad.
class Declination {
 public:
  /// The greatest error of at() relative to the model.
  static constexpr double kErrorRad = 5e-5;  // 0.003 degrees
  /// The fastest change of the horizontal field along the surface; the test searches the whole
  /// Earth.
  static constexpr double kSteepest_nT_per_km = 11;

  /// Uses the magnetic field in `year`, with its fraction.
  explicit Declination(double year) : year_(year) {}

  /// The angle from true north to magnetic north, rad, east positive, at a position at sea level in
  /// degrees.
  double at(double latitude_deg, double longitude_deg);

  /// How many times the model was computed.
  [[nodiscard]] int computed() const { return computed_; }

 private:
  [[nodiscard]] bool isNear(double latitude_deg, double longitude_deg) const;

  double year_;
  double latitude_deg_ = 0, longitude_deg_ = 0;
  double radius_km_ = -1;  ///< within which declination_rad_ holds
  double declination_rad_ = 0;
  int computed_ = 0;
};

}  // namespace glider::simulator
