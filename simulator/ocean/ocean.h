// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::simulator {

/// m/s, towards east and north.
struct Current {
  double east = 0;
  double north = 0;
};

/// An internal wave that travels east: lowers the thermocline by
/// amplitude · sin(2 pi ((t - start)/period - x/wavelength) + phase).
struct WaveSettings {
  double amplitude_m = 0;
  double period_s = 1200;
  double wavelength_m = 0;  ///< 0: the same everywhere
  double phase_rad = 0;
  double start_s = 0;
  double count = 0;  ///< how many waves pass; 0: they never end, nor have a beginning
};

struct OceanSettings {
  double surface_temperature = 20;  ///< degC
  double bottom_temperature = 10;   ///< degC
  double thermocline_depth_m = 15;
  double thermocline_thickness_m = 3;  ///< scale d of the tanh
  WaveSettings wave;
  double density = 1025;  ///< kg/m3, the same everywhere
  Current current;
  double water_depth_m = 60;   ///< mean
  double bottom_height_m = 0;  ///< amplitude of the bottom's waves
  double bottom_wavelength_m = 1000;
};

/// The true ocean. Depth z in m down, x and y in m east and north of the mission's start, t in s
/// since then. T(z) = Tb + (Ts - Tb)/2 (1 - tanh((z - z0 - eta)/d)); eta(z, x, t) has the shape of
/// the lowest mode between two layers: full at the thermocline and straight to 0 at surface and
/// bottom.
class Ocean {
 public:
  explicit Ocean(const OceanSettings& settings) : settings_(settings) {}

  [[nodiscard]] double temperature(double z, double x, double y, double t) const;  ///< degC
  [[nodiscard]] double density(double z) const;                                    ///< kg/m3
  [[nodiscard]] Current current() const { return settings_.current; }
  /// The water's own speed up (m/s) as the wave passes.
  [[nodiscard]] double verticalCurrent(double z, double x, double y, double t) const;
  [[nodiscard]] double waterDepth(double x, double y) const;
  /// Where the water has `temperature`; NaN if that is nowhere.
  [[nodiscard]] double isothermDepth(double temperature, double x, double y, double t) const;

 private:
  struct Wave {
    double lowered = 0;  ///< of the thermocline, m
    double rate = 0;     ///< m/s
  };
  [[nodiscard]] Wave wave(double x, double t) const;
  [[nodiscard]] double shape(double z, double water_depth) const;

  OceanSettings settings_;
};

}  // namespace glider::simulator
