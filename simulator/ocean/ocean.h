// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/ocean/bottom.h"
#include "simulator/ocean/settings.h"

namespace glider::simulator {

/// The factor by which sea water is denser under `pressure_pa` than at the surface: UNESCO 1983
/// (Fofonoff and Millard) at 35 and 10 degC.
double compression(double pressure_pa);

/// The true ocean. Depth z in m down, x and y in m east and north of the world's origin, t in s
/// since the world began. T(z) = Tb + (Ts - Tb)/2 (1 - tanh((z - z0 - eta)/d)), and a step across
/// the front; salinity in the same way; eta(z, x, t) has the shape of the lowest mode between two
/// layers: full at the thermocline and falling linearly to 0 at surface and bottom. Where the
/// bottom rises to the thermocline the wave ends.
class Ocean {
 public:
  explicit Ocean(const OceanSettings& settings);

  [[nodiscard]] double temperature(double z, double x, double y, double t) const;  ///< degC
  /// Practical salinity (PSS-78).
  [[nodiscard]] double salinity(double z, double x, double y, double t) const;
  /// In situ, kg/m3: that of the layers at no pressure, and compressed by the water above.
  [[nodiscard]] double density(double z, double x, double y, double t) const;
  [[nodiscard]] Planar current(double z, double x, double y) const;
  /// The water's own speed up (m/s) as the wave passes.
  [[nodiscard]] double verticalCurrent(double z, double x, double y, double t) const;
  /// What the swell adds to the pressure at a vehicle at the mean depth z, in m of water:
  /// amplitude · (P - share · M) · cos(k · distance - omega t), with P = cosh(k(h-z))/cosh(kh) of
  /// the pressure and M = sinh(k(h-z))/sinh(kh) of the motion that carries the vehicle along. In
  /// deep water both are exp(-kz): a vehicle that follows the water feels no swell. On a shelf
  /// the pressure reaches the bottom and the motion does not.
  [[nodiscard]] double swellPressure(double z, double x, double y, double t) const;
  [[nodiscard]] double waterDepth(double x, double y) const { return bottom_.depth(x, y); }
  /// The depth at which the water has `temperature`, m; NaN if there is none.
  [[nodiscard]] double isothermDepth(double temperature, double x, double y, double t) const;
  /// The share of the upper layer's water at z: 1 far above the thermocline, 0 far below.
  /// Properties that differ between the layers follow it.
  [[nodiscard]] double upperShare(double z, double x, double y, double t) const;

 private:
  struct Wave {
    double lowered = 0;  ///< of the thermocline, m
    double rate = 0;     ///< m/s
  };
  [[nodiscard]] Wave wave(double x, double t, double water_depth) const;
  [[nodiscard]] double shape(double z, double water_depth) const;
  /// 0 on the near side of the front, 1 far beyond it.
  [[nodiscard]] double beyondFront(double x, double y) const;

  OceanSettings settings_;
  Bottom bottom_;
  double swell_per_m_ = 0;  ///< wave number k of the swell, rad/m
};

}  // namespace glider::simulator
