// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/scenario/read_ocean.h"

#include "simulator/flight/navigator.h"

#include <algorithm>
#include <cmath>

namespace glider::simulator {
namespace {

/// Puts x and y where latitude_deg and longitude_deg say.
void place(Fields& f, const LocalFrame& frame, double& x, double& y) {
  const double latitude = f.required("latitude_deg", -89, 89);
  const double longitude = f.required("longitude_deg", -180, 180);
  if (!f.reader().failure()) {
    frame.locate({latitude, longitude}, x, y);
  }
}

/// Two fields that say something only together.
void together(Fields& f, const char* one, const char* other) {
  if (f.has(one) != f.has(other)) {
    const char* given = f.has(one) ? one : other;
    f.reader().refuse(given, fmt::format("needs `{}` as well", f.has(one) ? other : one));
  }
}

void readWater(Fields& f, OceanSettings& o, CtdSettings& ctd) {
  f.number("surface_temp_degC", o.surface_temperature, -2, 40);
  f.number("bottom_temp_degC", o.bottom_temperature, -2, 40);
  f.number("water_depth_m", o.bottom.depth_m, 5, 11000);
  f.number("thermocline_depth_m", o.thermocline_depth_m, 0.1, 10000);
  f.number("thermocline_thickness_m", o.thermocline_thickness_m, 0.01, 1000);
  f.number("density_kgm3", o.density, 990, 1060);
  f.number("density_step_kgm3", o.density_step, 0, 30);
  f.number("conductivity_Spm", ctd.conductivity, 0, 9);
  f.number("chlorophyll_ugpl", o.chlorophyll_ugpl, 0, 1000);
  together(f, "surface_oxygen_uM", "bottom_oxygen_uM");
  f.number("surface_oxygen_uM", o.surface_oxygen_uM, 0, 1000);
  f.number("bottom_oxygen_uM", o.bottom_oxygen_uM, 0, 1000);
}

void readCurrents(Fields& f, OceanSettings& o) {
  f.number("current_east_mps", o.current.east, -3, 3);
  f.number("current_north_mps", o.current.north, -3, 3);
  o.bottom_current = o.current;  // the same everywhere, unless the scenario says otherwise
  f.number("bottom_current_east_mps", o.bottom_current.east, -3, 3);
  f.number("bottom_current_north_mps", o.bottom_current.north, -3, 3);
}

void readBottom(Fields& f, OceanSettings& o) {
  BottomSettings& b = o.bottom;
  f.number("bottom_height_m", b.wave_height_m, 0, 5000);
  f.number("bottom_wavelength_m", b.wave_length_m, 1, 1e6);
  together(f, "bottom_slope_m_per_km", "bottom_slope_bearing_deg");
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
  f.number("period_s", w.period_s, 10, 1e6);
  f.number("wavelength_m", w.wavelength_m, 0, 1e6);
  f.number("phase_rad", w.phase_rad, -6.283185307179586, 6.283185307179586);
  f.number("start_s", w.start_s, -1e7, 1e7);
  f.number("count", w.count, 0, 1e6);
}

void readFront(Fields& f, const LocalFrame& frame, FrontSettings& front) {
  f.reader().only({"latitude_deg", "longitude_deg", "bearing_deg", "width_m", "step_degC"});
  place(f, frame, front.x, front.y);
  front.step_degC = f.required("step_degC", -20, 20);
  f.reader().number("bearing_deg");
  f.bearing("bearing_deg", front.bearing_rad);
  f.number("width_m", front.width_m, 1, 1e6);
}

Patch readPatch(Fields& f, const LocalFrame& frame) {
  f.reader().only(
      {"latitude_deg", "longitude_deg", "radius_m", "depth_m", "thickness_m", "peak_ugpl"});
  Patch patch;
  place(f, frame, patch.x, patch.y);
  patch.radius_m = f.required("radius_m", 1, 1e6);
  patch.depth_m = f.required("depth_m", 0, 10000);
  patch.thickness_m = f.required("thickness_m", 0.1, 10000);
  patch.peak_ugpl = f.required("peak_ugpl", 0, 1000);
  return patch;
}

Seamount readSeamount(Fields& f, const LocalFrame& frame) {
  f.reader().only({"latitude_deg", "longitude_deg", "radius_m", "height_m"});
  Seamount mount;
  place(f, frame, mount.x, mount.y);
  mount.radius_m = f.required("radius_m", 1, 1e6);
  mount.height_m = f.required("height_m", 0, 11000);
  return mount;
}

}  // namespace

void readOcean(ScenarioTables& tables, Scenario& scenario) {
  OceanSettings& o = scenario.ocean;
  const LocalFrame frame(scenario.latitude_deg, scenario.longitude_deg);
  tables.table("ocean", [&](Fields& f) {
    f.reader().only({"surface_temp_degC",
                     "bottom_temp_degC",
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
                     "conductivity_Spm",
                     "chlorophyll_ugpl",
                     "surface_oxygen_uM",
                     "bottom_oxygen_uM",
                     "wave",
                     "front",
                     "patch",
                     "seamount"});
    readWater(f, o, scenario.sensors.ctd);
    readCurrents(f, o);
    readBottom(f, o);
  });
  tables.part("ocean", "wave", [&](Fields& f) { readWave(f, o); });
  if (tables.has("ocean", "front")) {
    tables.part("ocean", "front", [&](Fields& f) { readFront(f, frame, o.front); });
  }
  tables.each("ocean", "patch", [&](Fields& f) { o.patches.push_back(readPatch(f, frame)); });
  tables.each("ocean", "seamount",
              [&](Fields& f) { o.bottom.seamounts.push_back(readSeamount(f, frame)); });
  if (!o.patches.empty() && std::isnan(o.chlorophyll_ugpl)) {
    o.chlorophyll_ugpl = 0;
  }
}

}  // namespace glider::simulator
