// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/geography/planar.h"

#include <vector>

/// What a scenario may specify about the water. Positions are m east and north of the mission's
/// start, bearings rad clockwise from north, depths m down.
namespace glider::simulator {

/// An internal wave that travels east: lowers the thermocline by
/// amplitude · sin(2 pi ((t - start)/period - x/wavelength) + phase).
struct WaveSettings {
  double amplitude_m = 0;
  double period_s = 1200;
  double wavelength_m = 0;  ///< 0: the same everywhere
  double phase_rad = 0;
  double start_s = 0;
  double count = 0;  ///< how many waves pass; 0: without beginning or end
};

/// A swell of small waves (Airy) on water of constant depth. Only its pressure counts: see
/// Ocean::swellPressure.
struct SwellSettings {
  double amplitude_m = 0;  ///< half of a wave's height
  double period_s = 10;
  double bearing_rad = 0;  ///< towards which it travels
  /// The share of the water's vertical motion that the vehicle follows. A small body that neither
  /// floats nor sinks follows all of it.
  double followed_share = 1;
};

/// A front: beyond it, along the bearing, the water is warmer and saltier by the steps at every
/// depth.
struct FrontSettings {
  double x = 0, y = 0;  ///< a place on it
  double bearing_rad = 0;
  double width_m = 500;  ///< scale of the tanh
  double step_degC = 0;
  double step_salinity = 0;
};

/// A hill on the bottom: height · exp(-(r/radius)²).
struct Seamount {
  double x = 0, y = 0;
  double radius_m = 0;
  double height_m = 0;
};

/// The bottom, from `[ocean]` of a scenario.
struct BottomSettings {
  double depth_m = 60;  ///< at the start, between the waves' crests and troughs
  double wave_height_m = 0;
  double wave_length_m = 1000;
  double slope = 0;              ///< m of depth per m along the bearing
  double slope_bearing_rad = 0;  ///< towards deeper water
  std::vector<Seamount> seamounts = {};
};

/// `[ocean]` of a scenario: the true water, which no fault changes.
struct OceanSettings {
  double surface_temperature = 20;  ///< degC
  double bottom_temperature = 10;   ///< degC
  double surface_salinity = 31.5;   ///< practical; these two are those of a shelf in summer
  double bottom_salinity = 33;
  double thermocline_depth_m = 15;
  double thermocline_thickness_m = 3;  ///< scale d of the tanh
  WaveSettings wave;
  SwellSettings swell;
  FrontSettings front;
  double density = 1025;    ///< kg/m3 at no pressure, in the middle of the thermocline
  double density_step = 0;  ///< kg/m3, denser below the thermocline than above it
  Planar current;           ///< at the surface
  Planar bottom_current;    ///< at the bottom; linear between the two
  BottomSettings bottom;
};

}  // namespace glider::simulator
