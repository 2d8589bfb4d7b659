// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/scenario/scenario.h"

#include "simulator/family/family.h"
#include "simulator/magnetism/magnetic_field.h"
#include "simulator/scenario/read_faults.h"
#include "simulator/scenario/read_ocean.h"
#include "simulator/tables/scenario_tables.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

namespace glider::simulator {

using platforms::TomlReader;

namespace {

constexpr double kNotGiven = std::numeric_limits<double>::quiet_NaN();

void readHead(Fields& f, const ScenarioTables& tables, Scenario& scenario) {
  TomlReader& r = f.reader();
  r.only({"name", "description", "seed", "skeleton", "duration_s", "isotherm_degC", "start",
          "ocean", "vehicle", "sensors", "faults", "operator"});
  for (const char* table : {"start", "ocean", "vehicle", "sensors", "faults", "operator"}) {
    if (f.has(table) && !tables.root()[table].is_table()) {
      r.refuse(table, "must be a table");
    }
  }
  scenario.name = r.text("name");
  scenario.description = r.textOr("description", "");
  const int64_t seed = f.has("seed") ? r.integer("seed") : 1;
  if (seed < 0) {
    r.refuse("seed", "must not be negative");
  }
  scenario.seed = static_cast<uint64_t>(seed);
  scenario.path = tables.file();
  scenario.skeleton_path = std::filesystem::path(tables.file()).parent_path() / r.text("skeleton");
  scenario.duration_s = r.number("duration_s");
  if (!(scenario.duration_s > 0 && scenario.duration_s <= kLongestFlight_s)) {
    r.refuse("duration_s", "must be above 0 and at most 60 days");
  }
  scenario.isotherm_degC = r.numberOr("isotherm_degC", kNotGiven);
}

/// Reads [[operator.put]].
Put readPut(Fields& f) {
  f.reader().only({"at_s", "sensor", "value"});
  Put put;
  put.at_s = f.required("at_s", 0, 1e9);
  put.sensor = f.reader().text("sensor");
  put.value = f.required("value", -1e12, 1e12);
  return put;
}

void readStart(Fields& f, Scenario& scenario) {
  f.reader().only({"latitude_deg", "longitude_deg", "heading_rad", "year"});
  scenario.latitude_deg = f.required("latitude_deg", -89, 89);
  scenario.longitude_deg = f.required("longitude_deg", -180, 180);
  f.number("heading_rad", scenario.vehicle.initial_heading_rad, 0, 6.283185307179586);
  f.number("year", scenario.year, kFirstMagneticYear, kLastMagneticYear);
}

/// Neutrally buoyant, unless the scenario says otherwise.
void readGlider(Fields& f, double density, FlightCoefficients& c) {
  f.number("mass_kg", c.mass_kg, 30, 200);
  c.hull_volume_m3 = c.mass_kg / density;
  f.number("hull_volume_m3", c.hull_volume_m3, 0.02, 0.3);
  f.number("drag", c.drag, 0.01, 2);
  f.number("induced_drag", c.induced_drag, 0.1, 100);
  f.number("wing_lift", c.wing_lift, 0.1, 20);
  f.number("hull_lift", c.hull_lift, 0, 20);
  f.number("reference_area_m2", c.reference_area_m2, 0.01, 1);
  f.number("compressibility_per_Pa", c.compressibility_per_pa, 0, 1e-8);
}

void readVehicle(Fields& f, const platforms::Platform& platform, Scenario& scenario) {
  const Family* family = familyOf(platform);
  const bool propelled = platform.motion && platform.motion->propelled;
  std::vector<std::string_view> keys = {"mass_kg",
                                        "hull_volume_m3",
                                        "drag",
                                        "induced_drag",
                                        "wing_lift",
                                        "hull_lift",
                                        "reference_area_m2",
                                        "compressibility_per_Pa",
                                        "battery",
                                        "cycle"};
  if (propelled) {
    keys.emplace_back("positive_buoyancy_kg");
  }
  if (family != nullptr) {
    keys.insert(keys.end(), family->vehicle_keys.begin(), family->vehicle_keys.end());
  }
  f.reader().only(keys);
  if (family != nullptr) {
    family->read_vehicle(f, scenario.own);
  }
  FlightCoefficients& c = scenario.vehicle.flight;
  // One scenario serves vehicles of both kinds: a propeller's has no use for the glider's numbers.
  FlightCoefficients unused = c;
  readGlider(f, scenario.ocean.density, propelled ? unused : c);
  if (propelled) {
    c.hull_volume_m3 = c.mass_kg / scenario.ocean.density;
    f.number("positive_buoyancy_kg", scenario.vehicle.positive_buoyancy_kg, -5, 5);
  }
}

/// Replaces the power of what always draws as the hotel: the first such row.
void replaceHotel(std::vector<platforms::Draw>& draws, double power_W) {
  const auto hotel = std::ranges::find(draws, platforms::DrawWhen::Always, &platforms::Draw::when);
  if (hotel != draws.end()) {
    hotel->amount = power_W;
  }
}

void readBattery(Fields& f, BatterySettings& battery) {
  f.reader().only({"capacity_kJ", "full_V", "empty_V", "resistance_ohm", "start_V", "hotel_W",
                   "sbc_W", "sbc_asleep_W"});
  platforms::Power& power = battery.power;
  battery.own_capacity = f.has("capacity_kJ");
  f.number("capacity_kJ", power.capacity_kj, 1, 1e6);
  f.number("full_V", power.full_V, 5, 40);
  f.number("empty_V", power.empty_V, 1, 40);
  if (!f.reader().failure() && power.empty_V >= power.full_V) {
    f.reader().refuse("empty_V", "must be below `full_V`");
  }
  f.number("resistance_ohm", power.resistance_ohm, 0, 10);
  battery.start_V = power.full_V;
  f.number("start_V", battery.start_V, power.empty_V, power.full_V);
  if (f.has("hotel_W")) {
    replaceHotel(power.draws, f.required("hotel_W", 0, 1000));
  }
  if (f.has("sbc_W")) {
    battery.sbc_W = f.required("sbc_W", 0, 1000);
  }
  if (f.has("sbc_asleep_W")) {
    battery.sbc_asleep_W = f.required("sbc_asleep_W", 0, 1000);
  }
}

void readCycle(Fields& f, CycleSettings& cycles) {
  f.reader().only({"mean_s", "spread_s", "long_share", "long_s"});
  f.number("mean_s", cycles.mean_s, 1, 20);
  f.number("spread_s", cycles.spread_s, 0, 5);
  f.number("long_share", cycles.long_share, 0, 1);
  f.number("long_s", cycles.long_s, 1, 60);
}

/// Reads all tables; the first failure stays in `tables`.
Scenario readScenario(ScenarioTables& tables, const platforms::Platform& platform) {
  Scenario scenario;
  scenario.vehicle = settingsOf(platform);
  tables.head([&](Fields& f) { readHead(f, tables, scenario); });
  tables.table("start", [&](Fields& f) { readStart(f, scenario); });
  if (tables.failure()) {
    return scenario;  // positions in the ocean are relative to the start
  }
  tables.startAt(scenario.latitude_deg, scenario.longitude_deg);
  readOcean(tables, scenario);
  tables.table("vehicle", [&](Fields& f) { readVehicle(f, platform, scenario); });
  tables.part("vehicle", "battery", [&](Fields& f) { readBattery(f, scenario.vehicle.battery); });
  tables.part("vehicle", "cycle", [&](Fields& f) { readCycle(f, scenario.cycles); });
  scenario.sensors.read(tables);
  readFaults(tables, scenario);
  tables.each("operator", "put", [&](Fields& f) { scenario.puts.push_back(readPut(f)); });
  return scenario;
}

bool isThere(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::exists(file, ignored);
}

/// Looks for the own mission of `scenario` in `bundled` if it is not beside the scenario.
void findSkeleton(Scenario& scenario, const std::filesystem::path& bundled) {
  const std::filesystem::path there = bundled / scenario.skeleton_path.filename();
  if (!bundled.empty() && !isThere(scenario.skeleton_path) && isThere(there)) {
    scenario.skeleton_path = there;
  }
}

/// `failure` of reading the own mission, with the folders that were searched if it is in none.
support::Failure withFolders(support::Failure failure, const Scenario& scenario,
                             const std::filesystem::path& bundled) {
  if (!isThere(scenario.skeleton_path) && failure.hint.empty()) {
    const std::filesystem::path folder = scenario.skeleton_path.parent_path();
    failure.hint = "looked for it in `" + (folder.empty() ? "." : folder.string()) + "`" +
                   (bundled.empty() ? "" : " and in `" + bundled.string() + "`") +
                   ": copy it there, or name another with `skeleton` in `" +
                   scenario.path.string() + "`";
  }
  return failure;
}

}  // namespace

support::Result<Scenario> loadScenario(const std::filesystem::path& path,
                                       const platforms::Platform& platform,
                                       support::SourceManager& sources,
                                       support::DiagnosticEngine& diagnostics,
                                       const std::filesystem::path& bundled) {
  auto root = platforms::parseToml(path);
  if (!root) {
    return std::unexpected(root.error());
  }
  ScenarioTables tables(path.string(), *root);
  Scenario scenario = readScenario(tables, platform);
  if (tables.failure()) {
    return std::unexpected(*tables.failure());
  }
  if (const Family* family = familyOf(platform)) {
    findSkeleton(scenario, bundled);
    auto own = family->load_own(scenario.skeleton_path, sources, diagnostics, scenario.own);
    if (!own) {
      return std::unexpected(withFolders(own.error(), scenario, bundled));
    }
  }
  return scenario;
}

}  // namespace glider::simulator
