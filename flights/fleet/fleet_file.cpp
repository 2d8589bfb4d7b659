// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/fleet/fleet_file.h"

#include "compiler/vehicles_own.h"
#include "platforms/load/toml_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string_view>

namespace glider::flights {
namespace {

using platforms::TomlReader;
namespace fs = std::filesystem;

constexpr double kHalfTurn_deg = 180;
constexpr double kTurn_deg = 360;
constexpr double kGreatestOffset_m = 100e3;  ///< the world's positions are those of a plane
constexpr double kGreatestLatitude_deg = 89;

/// A number from `lowest` to `highest`.
double within(TomlReader& reader, const char* key, double lowest, double highest) {
  const double value = reader.number(key);
  if (!(value >= lowest && value <= highest)) {
    reader.refuse(key, fmt::format("must be from {:g} to {:g}", lowest, highest));
  }
  return value;
}

bool isFileStem(const std::string& name) {
  constexpr size_t kMostLetters = 40;
  return !name.empty() && name.size() <= kMostLetters && name.front() != '-' &&
         std::ranges::all_of(name, [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                  c == '_' || c == '-';
         });
}

/// Where a file that is named in `fleet` is; one without a name is none.
fs::path besideFleet(const fs::path& fleet, const std::string& name) {
  return name.empty() ? fs::path() : fleet.parent_path() / name;
}

/// Refuses a key without the one that it belongs to.
void needBoth(TomlReader& reader, const toml::table& table, const char* one, const char* other) {
  for (const auto& [here, missing] : {std::pair(one, other), std::pair(other, one)}) {
    if (table.contains(here) && !table.contains(missing)) {
      reader.refuse(here, fmt::format("needs `{}` beside it", missing));
    }
  }
}

/// latitude_deg and longitude_deg, or bearing_deg and distance_m.
void readStart(TomlReader& reader, const toml::table& table, FleetVehicle& vehicle) {
  needBoth(reader, table, "latitude_deg", "longitude_deg");
  needBoth(reader, table, "bearing_deg", "distance_m");
  if (table.contains("latitude_deg") && table.contains("bearing_deg")) {
    reader.refuse("bearing_deg", "cannot be used with `latitude_deg`: a vehicle has one start");
  }
  if (reader.failure()) {
    return;
  }
  if (table.contains("latitude_deg")) {
    vehicle.place = {within(reader, "latitude_deg", -kGreatestLatitude_deg, kGreatestLatitude_deg),
                     within(reader, "longitude_deg", -kHalfTurn_deg, kHalfTurn_deg)};
  } else if (table.contains("bearing_deg")) {
    const double bearing_rad =
        within(reader, "bearing_deg", 0, kTurn_deg) / kHalfTurn_deg * std::numbers::pi;
    const double distance_m = within(reader, "distance_m", 0, kGreatestOffset_m);
    vehicle.offset = {distance_m * std::sin(bearing_rad), distance_m * std::cos(bearing_rad)};
  }
  if (table.contains("heading_deg")) {
    vehicle.heading_deg = within(reader, "heading_deg", 0, kTurn_deg);
  }
}

support::Result<FleetVehicle> readVehicle(const fs::path& file, const toml::table& table) {
  TomlReader reader(file.string(), table, "[[vehicle]]");
  reader.only({"name", "mission", "latitude_deg", "longitude_deg", "bearing_deg", "distance_m",
               "heading_deg", "mi", "set", "link", "address"});
  FleetVehicle vehicle;
  vehicle.name = reader.text("name");
  if (!isFileStem(vehicle.name)) {
    reader.refuse("name",
                  "must be of letters, digits, `_` and `-`, at most 40 of them: it names a folder");
  }
  vehicle.mission = besideFleet(file, reader.text("mission"));
  vehicle.mi = besideFleet(file, reader.textOr("mi", ""));
  vehicle.settings = reader.textsOr("set");
  for (const std::string& code : reader.textsOr("link")) {
    vehicle.user_code.push_back(besideFleet(file, code).string());
  }
  if (table.contains("address")) {
    const int64_t address = reader.integer("address");
    if (address < 1 || address > kMostAddress) {
      reader.refuse("address", fmt::format("must be from 1 to {}", kMostAddress));
    }
    vehicle.address = static_cast<uint32_t>(address);
  }
  readStart(reader, table, vehicle);
  if (reader.failure()) {
    return std::unexpected(*reader.failure());
  }
  return vehicle;
}

/// What is not in a table.
support::Result<Fleet> readHead(const fs::path& file, const toml::table& root) {
  TomlReader reader(file.string(), root, "the fleet file");
  reader.only({"scenario", "seed", "duration_s", "separation_m", "vehicle"});
  Fleet fleet;
  fleet.file = file;
  fleet.name = file.stem().string();
  fleet.scenario = reader.textOr("scenario", "default");
  if (fleet.scenario.ends_with(".toml")) {
    fleet.scenario = besideFleet(file, fleet.scenario).string();
  }
  if (root.contains("seed")) {
    const int64_t seed = reader.integer("seed");
    if (seed < 0) {
      reader.refuse("seed", "must not be negative");
    }
    fleet.seed = static_cast<uint64_t>(seed);
  }
  if (root.contains("duration_s")) {
    fleet.duration_s = within(reader, "duration_s", 1, simulator::kLongestFlight_s);
  }
  if (root.contains("separation_m")) {
    fleet.separation_m = within(reader, "separation_m", 1, kGreatestOffset_m);
  }
  const toml::array* vehicles = root["vehicle"].as_array();
  if (vehicles == nullptr || vehicles->empty() || !vehicles->is_array_of_tables()) {
    reader.refuse(
        "vehicle",
        "must be one or more tables: write `[[vehicle]]` with `name` and `mission` for each");
  } else if (vehicles->size() > kMostVehicles) {
    reader.refuse("vehicle", fmt::format("has {} vehicles; a fleet has at most {}",
                                         vehicles->size(), kMostVehicles));
  }
  if (reader.failure()) {
    return std::unexpected(*reader.failure());
  }
  return fleet;
}

/// The addresses that the file does not give: for all vehicles or for none.
support::Result<void> giveAddresses(const fs::path& file, const toml::array& tables,
                                    std::vector<FleetVehicle>& vehicles) {
  const auto given = std::ranges::count_if(
      vehicles, [](const FleetVehicle& vehicle) { return vehicle.address != 0; });
  for (size_t i = 0; i < vehicles.size(); ++i) {
    FleetVehicle& vehicle = vehicles[i];
    const auto first = std::ranges::find(vehicles, vehicle.address, &FleetVehicle::address);
    TomlReader reader(file.string(), *tables[i].as_table(), "[[vehicle]]");
    if (given == 0) {
      vehicle.address = static_cast<uint32_t>(i) + 1;
    } else if (vehicle.address == 0) {
      reader.refuse("address", fmt::format("is missing for `{}`: give all vehicles one, or none",
                                           vehicle.name));
    } else if (&*first != &vehicle) {
      reader.refuse("address", fmt::format("{} is that of `{}` too: two vehicles would send at the "
                                           "same time",
                                           vehicle.address, first->name));
    }
    if (reader.failure()) {
      return std::unexpected(*reader.failure());
    }
  }
  return {};
}

}  // namespace

simulator::GeoPosition startOf(const FleetVehicle& vehicle, const simulator::Scenario& scenario) {
  if (vehicle.place) {
    return *vehicle.place;
  }
  if (!vehicle.offset) {
    return {scenario.latitude_deg, scenario.longitude_deg};
  }
  return simulator::LocalFrame(scenario.latitude_deg, scenario.longitude_deg)
      .position(vehicle.offset->east_m, vehicle.offset->north_m);
}

support::Failure ofVehicle(const FleetVehicle& vehicle, support::Failure failure) {
  failure.message = fmt::format("vehicle `{}`: {}", vehicle.name, failure.message);
  return failure;
}

bool isFleetFile(const fs::path& path) {
  return compiler::kindOf(path) == compiler::MissionKind::Fleet;
}

support::Result<Fleet> loadFleet(const fs::path& path) {
  const auto root = platforms::parseToml(path);
  if (!root) {
    return std::unexpected(root.error());
  }
  auto fleet = readHead(path, *root);
  if (!fleet) {
    return fleet;
  }
  std::set<std::string> names;
  for (const toml::node& node : *(*root)["vehicle"].as_array()) {
    auto vehicle = readVehicle(path, *node.as_table());
    if (!vehicle) {
      return std::unexpected(vehicle.error());
    }
    if (!names.insert(vehicle->name).second) {
      TomlReader reader(path.string(), *node.as_table(), "[[vehicle]]");
      reader.refuse("name", fmt::format("is that of another vehicle too: `{}`", vehicle->name));
      return std::unexpected(*reader.failure());
    }
    fleet->vehicles.push_back(std::move(*vehicle));
  }
  if (auto given = giveAddresses(path, *(*root)["vehicle"].as_array(), fleet->vehicles); !given) {
    return std::unexpected(given.error());
  }
  return fleet;
}

uint32_t slotsOf(const Fleet& fleet) {
  return std::ranges::max(fleet.vehicles, {}, &FleetVehicle::address).address;
}

}  // namespace glider::flights
