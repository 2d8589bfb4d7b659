// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/dictionary.h"
#include "platforms/load/dictionary.h"
#include "platforms/load/load_platform.h"
#include "platforms/load/longest_lag.h"
#include "platforms/load/read_envelope.h"
#include "platforms/load/read_instruments.h"
#include "platforms/load/read_modem.h"
#include "platforms/load/read_motion.h"
#include "platforms/load/read_numbers.h"
#include "platforms/load/seat_sensors.h"
#include "platforms/load/sensor_unit.h"
#include "platforms/load/surface_reading.h"
#include "platforms/load/toml_reader.h"
#include "support/diagnostics/ids/vehicle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace glider::platforms {
namespace {

/// Reads how often and how exactly the sensor is reported to the SBC.
void readReporting(TomlReader& reader, double cycle_s, PlatformSensor& sensor) {
  constexpr double kMostCycles = 255;
  sensor.every_s = reader.numberOr("every_s", cycle_s);
  sensor.dead_band = reader.numberOr("dead_band", 0);
  const double cycles = sensor.every_s / cycle_s;
  if (!(cycles >= 1 && cycles <= kMostCycles && cycles == std::floor(cycles))) {
    reader.refuse("every_s", "must be a multiple of `cycle_s`, at most 255 of them");
  }
  if (!(sensor.every_s <= std::max(sensor.stale_after_s, cycle_s))) {
    reader.refuse("every_s", "must not be above `stale_after_s`");
  }
  if (!(sensor.dead_band >= 0 && sensor.dead_band <= sensor.highest - sensor.lowest)) {
    reader.refuse("dead_band", "must be between 0 and the whole range");
  }
}

PlatformSensor readSensor(TomlReader& reader, size_t id, double cycle_s) {
  reader.only({"name", "alias", "unit", "lowest", "highest", "stale_after_s", "every_s",
               "dead_band", "computer", "bytes", "noise", "magnetic", "what", "counts", "states",
               "role", "source"});
  PlatformSensor sensor;
  sensor.id = static_cast<uint16_t>(id);
  sensor.name = reader.text("name");
  sensor.alias = reader.textOr("alias", "");
  sensor.unit = reader.text("unit");
  sensor.lowest = reader.number("lowest");
  sensor.highest = reader.number("highest");
  sensor.stale_after_s = reader.number("stale_after_s");
  const std::string computer = reader.text("computer");
  sensor.computer = computer == "science" ? Computer::Science : Computer::Flight;
  const int64_t bytes = reader.integer("bytes");
  sensor.bytes = static_cast<uint8_t>(bytes);
  sensor.noise = reader.numberOr("noise", 0);
  sensor.what = reader.text("what");
  sensor.role = reader.textOr("role", "");
  sensor.source = reader.textOr("source", "");
  if (!sensor.role.empty() && !isRole(sensor.role)) {
    reader.refuse("role", "is none of hooks/protocol/roles.def");
  }
  if (!interpretUnit(sensor)) {
    reader.refuse("unit", "is not a unit of the language, `lat`, `lon`, `timestamp` or `1`");
  }
  if (!(sensor.lowest < sensor.highest)) {
    reader.refuse("highest", "must be above `lowest`");
  }
  if (!(sensor.stale_after_s > 0)) {
    reader.refuse("stale_after_s", "must be above 0");
  }
  readReporting(reader, cycle_s, sensor);
  if (!(sensor.noise >= 0)) {
    reader.refuse("noise", "must not be below 0");
  }
  sensor.states = reader.textsOr("states");
  sensor.counts = reader.flagOr("counts", bytes == 1 || !sensor.states.empty());
  sensor.magnetic = reader.flagOr("magnetic", false);
  if ((sensor.magnetic || sensor.name == kVariationSensor) && sensor.unit != "rad") {
    reader.refuse("unit", "of a magnetic heading or `m_gps_mag_var` must be \"rad\"");
  }
  if (computer != "flight" && computer != "science") {
    reader.refuse("computer", "must be \"flight\" or \"science\"");
  }
  if (bytes != 1 && bytes != 4 && bytes != 8) {
    reader.refuse("bytes", "must be 1, 4 or 8");
  }
  return sensor;
}

support::Result<void> readSensors(const std::string& file, const toml::table& root,
                                  Platform& platform) {
  const toml::array* list = root["sensor"].as_array();
  if (list == nullptr || list->empty() || list->size() > GLIDER_MOST_SENSORS) {
    return support::fail(
        support::diagnostics::badDataFile, file,
        fmt::format("it must have between 1 and {} [[sensor]] tables", GLIDER_MOST_SENSORS));
  }
  for (const toml::node& node : *list) {
    const toml::table* table = node.as_table();
    if (table == nullptr) {
      return support::fail(support::diagnostics::badDataFile, file,
                           "`sensor` must be [[sensor]] tables");
    }
    TomlReader reader(file, *table, fmt::format("sensor {}", platform.sensors.size()));
    PlatformSensor sensor = readSensor(reader, platform.sensors.size(), platform.envelope.cycle_s);
    const bool taken = platform.find(sensor.name) != nullptr ||
                       (!sensor.alias.empty() && platform.find(sensor.alias) != nullptr);
    if (taken) {
      reader.refuse("name", "or its alias is taken by an earlier sensor");
    }
    if (reader.failure()) {
      return std::unexpected(*reader.failure());
    }
    platform.sensors.push_back(std::move(sensor));
  }
  return {};
}

constexpr NumberKey<EnvironmentModel> kWorld[] = {
    {"start_depth_m", &EnvironmentModel::start_depth_m},
    {"surface_depth_m", &EnvironmentModel::surface_depth_m},
    {"slowest_climb_m_s", &EnvironmentModel::slowest_climb_m_s},
    {"turn_s", &EnvironmentModel::turn_s},
    {"depth_error_m", &EnvironmentModel::depth_error_m},
    {"tick_gap_s", &EnvironmentModel::tick_gap_s},
    {"through_water_m_s", &EnvironmentModel::through_water_m_s},
    {"steering_error_m", &EnvironmentModel::steering_error_m},
    {"surface_drift_m_s", &EnvironmentModel::surface_drift_m_s}};

EnvironmentModel readWorld(TomlReader& reader) {
  auto world = readNumbers<EnvironmentModel>(reader, kWorld,
                                             {"line_lag_s", "command_delay_s", "climb_hold_m"});
  for (const auto& [key, field] : {std::pair{"line_lag_s", &EnvironmentModel::line_lag_s},
                                   std::pair{"command_delay_s", &EnvironmentModel::command_delay_s},
                                   std::pair{"climb_hold_m", &EnvironmentModel::climb_hold_m}}) {
    world.*field = reader.numberOr(key, 0);
    if (!(world.*field >= 0)) {
      reader.refuse(key, "must not be below 0");
    }
  }
  if (const double least = world.depth_error_m + kSurfaceReadingM; world.start_depth_m < least) {
    reader.refuse(
        "start_depth_m",
        fmt::format("must be at least {:g}: a program waits for a depth reading of "
                    "`start_depth_m` less `depth_error_m`, and waves hide less than {:g} m",
                    least, kSurfaceReadingM));
  }
  return world;
}

/// Rows of the power table whose device is an instrument that missions switch.
void linkPower(Platform& platform) {
  for (Draw& draw : platform.power.draws) {
    const auto found = std::ranges::find(platform.instruments, draw.device, &Instrument::name);
    const bool lasts = draw.when == DrawWhen::Always || draw.when == DrawWhen::Read;
    if (found != platform.instruments.end() && lasts) {
      draw.instrument = static_cast<uint32_t>(found - platform.instruments.begin());
      draw.reading_s = found->reading_s;
    }
  }
}

}  // namespace

const PlatformSensor* Platform::find(std::string_view wanted) const {
  auto found = std::ranges::find_if(sensors, [&](const PlatformSensor& sensor) {
    return sensor.name == wanted || (!sensor.alias.empty() && sensor.alias == wanted);
  });
  return found == sensors.end() ? nullptr : &*found;
}

bool Platform::seatIsOnBoard() const {
  return !front_seats.empty() && front_seats.front() != "hooks";
}

support::Result<Platform> loadPlatform(const std::filesystem::path& path) {
  auto root = parseToml(path);
  if (!root) {
    return std::unexpected(root.error());
  }
  Platform platform;
  TomlReader reader(path.string(), *root, "the platform");
  reader.only({"name", "description", "family", "front_seats", "envelope", "world", "motion",
               "power", "instrument", "modem", "sensor"});
  platform.name = reader.text("name");
  if (!isName(platform.name)) {
    reader.refuse("name", "must be letters, digits and `_`, and begin with a letter");
  } else if (platform.name != path.stem()) {
    reader.refuse("name", "must be that of the file: missions find the platform by it");
  }
  platform.description = reader.text("description");
  platform.family = reader.textOr("family", "");
  platform.front_seats = reader.textsOr("front_seats");
  TomlReader envelope = tableOf(path.string(), std::as_const(*root)["envelope"], "[envelope]");
  platform.envelope = readEnvelope(envelope);
  TomlReader world = tableOf(path.string(), std::as_const(*root)["world"], "[world]");
  platform.world = readWorld(world);
  if (!(platform.world.line_lag_s <= kLongestLagCycles * platform.envelope.cycle_s)) {
    world.refuse("line_lag_s",
                 fmt::format("must be at most {:g} times `cycle_s`: so long a program "
                             "leaves an instruction alone",
                             kLongestLagCycles));
  }
  for (const TomlReader* read : {&reader, &envelope, &world}) {
    if (read->failure()) {
      return std::unexpected(*read->failure());
    }
  }
  // The power table names sensors.
  if (auto read = readSensors(path.string(), *root, platform); !read) {
    return std::unexpected(read.error());
  }
  if (auto read = readMotionAndPower(path.string(), *root, platform); !read) {
    return std::unexpected(read.error());
  }
  auto instruments = readInstruments(path.string(), *root, platform);
  if (!instruments) {
    return std::unexpected(instruments.error());
  }
  platform.instruments = *std::move(instruments);
  linkPower(platform);
  auto modem = readModem(path.string(), *root);
  if (!modem) {
    return std::unexpected(modem.error());
  }
  platform.modem = *std::move(modem);
  if (platform.seatIsOnBoard()) {
    addSeatSensors(platform);
  }
  return platform;
}

}  // namespace glider::platforms
