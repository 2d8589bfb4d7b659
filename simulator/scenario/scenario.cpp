// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/scenario/scenario.h"

#include "platforms/load/toml_reader.h"
#include "simulator/flight/skeleton.h"
#include "slocum/mission_files/argument_files.h"
#include "slocum/mission_files/read.h"
#include "support/files.h"

#include <cmath>
#include <limits>

namespace glider::simulator {

using platforms::TomlReader;
using support::DiagnosticId;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A reader of number fields with bounds; tables that are left out give every default.
class Fields {
 public:
  Fields(const std::string& file, const toml::node_view<const toml::node>& at,
         const std::string& where)
      : reader_(file, at.as_table() != nullptr ? *at.as_table() : none(), where) {}

  /// Puts the number `key`, if it is there, into `into`.
  void number(const char* key, double& into, double lowest, double highest) {
    into = reader_.numberOr(key, into);
    if (!(into >= lowest && into <= highest) && !reader_.failure()) {
      reader_.refuse(key, fmt::format("must be between {} and {}", lowest, highest));
    }
  }
  TomlReader& reader() { return reader_; }

 private:
  static const toml::table& none() {
    static const toml::table kNone;
    return kNone;
  }
  TomlReader reader_;
};

/// Reads the tables of one scenario file; the first failure is kept.
class ScenarioReader {
 public:
  ScenarioReader(std::string file, const toml::table& root) : file_(std::move(file)), root_(root) {}

  Scenario read() {
    head();
    start();
    ocean();
    wave();
    vehicle();
    sensors();
    return std::move(scenario_);
  }
  [[nodiscard]] const std::optional<support::Failure>& failure() const { return failure_; }

 private:
  void keep(const TomlReader& reader) {
    if (!failure_ && reader.failure()) {
      failure_ = reader.failure();
    }
  }
  Fields fields(const char* table) { return {file_, root_[table], fmt::format("[{}]", table)}; }

  void head() {
    TomlReader r(file_, root_, "the scenario");
    r.only({"name", "description", "seed", "skeleton", "duration_s", "isotherm_degC", "start",
            "ocean", "vehicle", "sensors"});
    for (const char* table : {"start", "ocean", "vehicle", "sensors"}) {
      if (root_.contains(table) && !root_[table].is_table()) {
        r.refuse(table, "must be a table");
      }
    }
    scenario_.name = r.text("name");
    scenario_.description = r.textOr("description", "");
    const int64_t seed = root_.contains("seed") ? r.integer("seed") : 1;
    if (seed < 0) {
      r.refuse("seed", "must not be negative");
    }
    scenario_.seed = static_cast<uint64_t>(seed);
    scenario_.skeleton_path = std::filesystem::path(file_).parent_path() / r.text("skeleton");
    scenario_.duration_s = r.number("duration_s");
    constexpr double kLongest = 60 * 86400;
    if (!(scenario_.duration_s > 0 && scenario_.duration_s <= kLongest)) {
      r.refuse("duration_s", "must be above 0 and at most 60 days");
    }
    scenario_.isotherm_degC = r.numberOr("isotherm_degC", 0);
    if (!root_.contains("isotherm_degC")) {
      scenario_.isotherm_degC = kNaN;
    }
    keep(r);
  }

  void start() {
    Fields f = fields("start");
    f.reader().only({"latitude_deg", "longitude_deg", "heading_rad"});
    scenario_.latitude_deg = f.reader().number("latitude_deg");
    scenario_.longitude_deg = f.reader().number("longitude_deg");
    f.number("latitude_deg", scenario_.latitude_deg, -89, 89);
    f.number("longitude_deg", scenario_.longitude_deg, -180, 180);
    f.number("heading_rad", scenario_.vehicle.initial_heading_rad, 0, 6.283185307179586);
    keep(f.reader());
  }

  void ocean() {
    OceanSettings& o = scenario_.ocean;
    Fields f = fields("ocean");
    f.reader().only({"surface_temp_degC", "bottom_temp_degC", "thermocline_depth_m",
                     "thermocline_thickness_m", "density_kgm3", "current_east_mps",
                     "current_north_mps", "water_depth_m", "bottom_height_m", "bottom_wavelength_m",
                     "conductivity_Spm", "wave"});
    f.number("surface_temp_degC", o.surface_temperature, -2, 40);
    f.number("bottom_temp_degC", o.bottom_temperature, -2, 40);
    f.number("water_depth_m", o.water_depth_m, 5, 11000);
    f.number("thermocline_depth_m", o.thermocline_depth_m, 0.1, 10000);
    f.number("thermocline_thickness_m", o.thermocline_thickness_m, 0.01, 1000);
    f.number("density_kgm3", o.density, 990, 1060);
    f.number("current_east_mps", o.current.east, -3, 3);
    f.number("current_north_mps", o.current.north, -3, 3);
    f.number("bottom_height_m", o.bottom_height_m, 0, 5000);
    f.number("bottom_wavelength_m", o.bottom_wavelength_m, 1, 1e6);
    f.number("conductivity_Spm", scenario_.sensors.conductivity, 0, 9);
    if (!f.reader().failure() && o.thermocline_depth_m >= o.water_depth_m - o.bottom_height_m) {
      f.reader().refuse("thermocline_depth_m", "must be above the bottom everywhere");
    }
    keep(f.reader());
  }

  void wave() {
    const auto at = root_["ocean"]["wave"];
    if (!at) {
      return;
    }
    if (!at.is_table()) {
      Fields ocean = fields("ocean");
      ocean.reader().refuse("wave", "must be a table");
      keep(ocean.reader());
      return;
    }
    const OceanSettings& o = scenario_.ocean;
    WaveSettings& w = scenario_.ocean.wave;
    Fields f(file_, at, "[ocean.wave]");
    f.reader().only({"amplitude_m", "period_s", "wavelength_m", "phase_rad", "start_s", "count"});
    // Larger waves would fold the water over.
    const double most = 0.95 * std::min(o.thermocline_depth_m, o.water_depth_m - o.bottom_height_m -
                                                                   o.thermocline_depth_m);
    f.number("amplitude_m", w.amplitude_m, 0, most);
    f.number("period_s", w.period_s, 10, 1e6);
    f.number("wavelength_m", w.wavelength_m, 0, 1e6);
    f.number("phase_rad", w.phase_rad, -6.283185307179586, 6.283185307179586);
    f.number("start_s", w.start_s, -1e7, 1e7);
    f.number("count", w.count, 0, 1e6);
    keep(f.reader());
  }

  void vehicle() {
    FlightCoefficients& c = scenario_.vehicle.flight;
    Fields f = fields("vehicle");
    f.reader().only({"mass_kg", "hull_volume_m3", "drag", "induced_drag", "wing_lift", "hull_lift",
                     "reference_area_m2", "compressibility_per_Pa"});
    f.number("mass_kg", c.mass_kg, 30, 200);
    c.hull_volume_m3 =
        c.mass_kg / scenario_.ocean.density;  // neutral, unless the scenario says otherwise
    f.number("hull_volume_m3", c.hull_volume_m3, 0.02, 0.3);
    f.number("drag", c.drag, 0.01, 2);
    f.number("induced_drag", c.induced_drag, 0.1, 100);
    f.number("wing_lift", c.wing_lift, 0.1, 20);
    f.number("hull_lift", c.hull_lift, 0, 20);
    f.number("reference_area_m2", c.reference_area_m2, 0.01, 1);
    f.number("compressibility_per_Pa", c.compressibility_per_pa, 0, 1e-8);
    keep(f.reader());
  }

  void sensors() {
    SensorSettings& s = scenario_.sensors;
    Fields f = fields("sensors");
    f.reader().only({"depth_m", "pitch_rad", "heading_rad", "altitude_m", "gps_m",
                     "temperature_degC", "ctd_dropout", "stale_water"});
    f.number("depth_m", s.depth_m, 0, 10);
    f.number("pitch_rad", s.pitch_rad, 0, 1);
    f.number("heading_rad", s.heading_rad, 0, 1);
    f.number("altitude_m", s.altitude_m, 0, 100);
    f.number("gps_m", s.gps_m, 0, 10000);
    f.number("temperature_degC", s.temperature_degC, 0, 10);
    f.number("ctd_dropout", s.ctd_dropout, 0, 1);
    keep(f.reader());
    staleWater();
  }

  void staleWater() {
    const auto list = root_["sensors"]["stale_water"];
    if (!list) {
      return;
    }
    const toml::array* array = list.as_array();
    for (size_t i = 0; array != nullptr && i < array->size(); ++i) {
      Fields f(file_, list[i], "[[sensors.stale_water]]");
      f.reader().only({"from_s", "to_s"});
      StaleWater stale{f.reader().number("from_s"), f.reader().number("to_s")};
      if (!(stale.from_s < stale.to_s)) {
        f.reader().refuse("to_s", "must be after `from_s`");
      }
      keep(f.reader());
      scenario_.sensors.stale_water.push_back(stale);
    }
    if (array == nullptr) {
      Fields f = fields("sensors");
      f.reader().refuse("stale_water", "must be [[sensors.stale_water]] tables");
      keep(f.reader());
    }
  }

  std::string file_;
  const toml::table& root_;
  Scenario scenario_;
  std::optional<support::Failure> failure_;
};

support::Result<void> loadSkeleton(Scenario& scenario, support::SourceManager& sources,
                                   support::DiagnosticEngine& diagnostics) {
  auto text = support::readFile(scenario.skeleton_path);
  if (!text) {
    return std::unexpected(text.error());
  }
  const size_t errors_before = diagnostics.errorCount();
  const std::string name = scenario.skeleton_path.string();
  const uint32_t file = sources.add(name, std::move(*text));
  if (auto mission = slocum::readMission(sources, file, diagnostics)) {
    slocum::applyArgumentFiles(*mission, scenario.skeleton_path.parent_path(), sources,
                               diagnostics);
    checkSkeleton(*mission, {file, 0, 0}, diagnostics);
    scenario.skeleton = std::move(*mission);
  }
  if (diagnostics.errorCount() != errors_before) {
    return support::fail(DiagnosticId::skeletonMistakes, name,
                         diagnostics.errorCount() - errors_before);
  }
  return {};
}

}  // namespace

support::Result<Scenario> loadScenario(const std::filesystem::path& path,
                                       support::SourceManager& sources,
                                       support::DiagnosticEngine& diagnostics) {
  auto root = platforms::parseToml(path);
  if (!root) {
    return std::unexpected(root.error());
  }
  ScenarioReader reader(path.string(), *root);
  Scenario scenario = reader.read();
  if (reader.failure()) {
    return std::unexpected(*reader.failure());
  }
  if (auto loaded = loadSkeleton(scenario, sources, diagnostics); !loaded) {
    return std::unexpected(loaded.error());
  }
  return scenario;
}

}  // namespace glider::simulator
