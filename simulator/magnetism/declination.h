// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::simulator {

/// The declination along the way of a vehicle. A glider moves little between two control cycles, so
/// the model is computed again only where the declination may have changed by more than
/// kErrorRad.
class Declination {
 public:
  /// How far at() may be from the model.
  static constexpr double kErrorRad = 5e-5;  // 0.003 degrees
  /// How fast the horizontal field changes along the surface, at most; the test searches the
  /// Earth.
  static constexpr double kSteepest_nT_per_km = 11;

  /// Of the magnetic field in `year`, with its fraction.
  explicit Declination(double year) : year_(year) {}

  /// Of magnetic north from true north, rad, east positive; at a position at sea level, degrees.
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
