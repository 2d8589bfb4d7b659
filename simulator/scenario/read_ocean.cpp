// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/scenario/read_ocean.h"

#include "simulator/sensors/sensor_list.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace glider::simulator {
namespace {

/// The keys of [ocean], including those that sensors read.
std::vector<std::string_view> knownKeys() {
  std::vector<std::string_view> keys = {"surface_temp_degC",
                                        "bottom_temp_degC",
                                        "surface_salinity",
                                        "bottom_salinity",
                                        "thermocline_depth_m",
                                        "thermocline_thickness_m",
                                        "density_kgm3",
                                        "density_step_kgm3",
                                        "current_east_mps",
                                        "current_north_mps",
                                        "bottom_current_east_mps",
                                        "bottom_current_north_mps",
                                        "water_depth_m",
                                        "bottom_height_m",
                                        "bottom_wavelength_m",
                                        "bottom_slope_m_per_km",
                                        "bottom_slope_bearing_deg",
                                        "wave",
                                        "swell",
                                        "front",
                                        "seamount"};
  const std::vector<std::string_view> of_sensors = sensorKeys("ocean");
  keys.insert(keys.end(), of_sensors.begin(), of_sensors.end());
  return keys;
}

void readWater(Fields& f, OceanSettings& o) {
  f.number("surface_temp_degC", o.surface_temperature, -2, 40);
  f.number("bottom_temp_degC", o.bottom_temperature, -2, 40);
  f.together("surface_salinity", "bottom_salinity");
  f.number("surface_salinity", o.surface_salinity, 0, 42);
  f.number("bottom_salinity", o.bottom_salinity, 0, 42);
  for (const char* key : {"surface_salinity", "bottom_salinity"}) {
    if (f.has(key) && f.has("conductivity_Spm")) {
      f.reader().refuse(key, "has no effect with `conductivity_Spm`");
    }
  }
  f.number("water_depth_m", o.bottom.depth_m, 5, 11000);
  f.number("thermocline_depth_m", o.thermocline_depth_m, 0.1, 10000);
  f.number("thermocline_thickness_m", o.thermocline_thickness_m, 0.01, 1000);
  f.number("density_kgm3", o.density, 990, 1060);
  f.number("density_step_kgm3", o.density_step, 0, 30);
}

void readCurrents(Fields& f, OceanSettings& o) {
  f.number("current_east_mps", o.current.east, -3, 3);
  f.number("current_north_mps", o.current.north, -3, 3);
  o.bottom_current = o.current;  // the same at all depths, unless the scenario says otherwise
  f.number("bottom_current_east_mps", o.bottom_current.east, -3, 3);
  f.number("bottom_current_north_mps", o.bottom_current.north, -3, 3);
}

void readBottom(Fields& f, OceanSettings& o) {
  BottomSettings& b = o.bottom;
  f.number("bottom_height_m", b.wave_height_m, 0, 5000);
  f.number("bottom_wavelength_m", b.wave_length_m, 1, 1e6);
  f.together("bottom_slope_m_per_km", "bottom_slope_bearing_deg");
  double slope = 0;
  f.number("bottom_slope_m_per_km", slope, 0, 1000);
  b.slope = slope / 1000;
  f.bearing("bottom_slope_bearing_deg", b.slope_bearing_rad);
  if (!f.reader().failure() && o.thermocline_depth_m >= b.depth_m - b.wave_height_m) {
    f.reader().refuse("thermocline_depth_m", "must be above the bottom everywhere");
  }
}

void readWave(Fields& f, OceanSettings& o) {
  WaveSettings& w = o.wave;
  f.reader().only({"amplitude_m", "period_s", "wavelength_m", "phase_rad", "start_s", "count"});
  // Larger waves would fold the water over.
  const double below = o.bottom.depth_m - o.bottom.wave_height_m - o.thermocline_depth_m;
  f.number("amplitude_m", w.amplitude_m, 0, 0.95 * std::min(o.thermocline_depth_m, below));
  f.number("period_s", w.period_s, 2, 1e6);
  f.number("wavelength_m", w.wavelength_m, 0, 1e6);
  f.number("phase_rad", w.phase_rad, -6.283185307179586, 6.283185307179586);
  f.number("start_s", w.start_s, -1e7, 1e7);
  f.number("count", w.count, 0, 1e6);
}

void readSwell(Fields& f, SwellSettings& s) {
  f.reader().only({"amplitude_m", "period_s", "bearing_deg", "followed_share"});
  f.number("amplitude_m", s.amplitude_m, 0, 10);
  f.number("period_s", s.period_s, 2, 30);
  f.bearing("bearing_deg", s.bearing_rad);
  f.number("followed_share", s.followed_share, 0, 1);
}

void readFront(Fields& f, FrontSettings& front) {
  f.reader().only(
      {"latitude_deg", "longitude_deg", "bearing_deg", "width_m", "step_degC", "step_salinity"});
  f.place(front.x, front.y);
  front.step_degC = f.required("step_degC", -20, 20);
  f.number("step_salinity", front.step_salinity, -20, 20);
  f.reader().number("bearing_deg");
  f.bearing("bearing_deg", front.bearing_rad);
  f.number("width_m", front.width_m, 1, 1e6);
}

Seamount readSeamount(Fields& f) {
  f.reader().only({"latitude_deg", "longitude_deg", "radius_m", "height_m"});
  Seamount mount;
  f.place(mount.x, mount.y);
  mount.radius_m = f.required("radius_m", 1, 1e6);
  mount.height_m = f.required("height_m", 0, 11000);
  return mount;
}

}  // namespace

void readOcean(ScenarioTables& tables, Scenario& scenario) {
  OceanSettings& o = scenario.ocean;
  tables.table("ocean", [&](Fields& f) {
    f.reader().only(knownKeys());
    readWater(f, o);
    readCurrents(f, o);
    readBottom(f, o);
  });
  tables.part("ocean", "wave", [&](Fields& f) { readWave(f, o); });
  tables.part("ocean", "swell", [&](Fields& f) { readSwell(f, o.swell); });
  if (tables.has("ocean", "front")) {
    tables.part("ocean", "front", [&](Fields& f) { readFront(f, o.front); });
  }
  tables.each("ocean", "seamount",
              [&](Fields& f) { o.bottom.seamounts.push_back(readSeamount(f)); });
}

}  // namespace glider::simulator
