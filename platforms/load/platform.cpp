// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/dictionary.h"
#include "platforms/load/dictionary.h"
#include "platforms/load/load_platform.h"
#include "platforms/load/seat_sensors.h"
#include "platforms/load/sensor_unit.h"
#include "platforms/load/surface_reading.h"
#include "platforms/load/toml_reader.h"
#include "support/diagnostics/ids/vehicle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
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

/// Reads a table of numbers above 0, all of them required; `others` are keys that it may also have.
template <typename T, size_t kCount>
T readNumbers(TomlReader& reader, const std::pair<const char*, double T::*> (&fields)[kCount],
              std::vector<std::string_view> others = {}) {
  std::vector<std::string_view> keys = std::move(others);
  for (const auto& [key, field] : fields) {
    keys.emplace_back(key);
  }
  reader.only(keys);
  T numbers;
  for (const auto& [key, field] : fields) {
    numbers.*field = reader.number(key);
    if (!(numbers.*field > 0)) {
      reader.refuse(key, "must be above 0");
    }
  }
  return numbers;
}

constexpr std::pair<const char*, double Envelope::*> kEnvelope[] = {
    {"greatest_depth_m", &Envelope::greatest_depth_m},
    {"vertical_rate_m_s", &Envelope::vertical_rate_m_s},
    {"inflection_overshoot_m", &Envelope::inflection_overshoot_m},
    {"drift_m_s", &Envelope::drift_m_s},
    {"cycle_s", &Envelope::cycle_s}};

/// Of a vehicle that glides.
constexpr std::pair<const char*, double Envelope::*> kGlides[] = {
    {"steepest_pitch_rad", &Envelope::steepest_pitch_rad},
    {"shallowest_pitch_rad", &Envelope::shallowest_pitch_rad},
    {"pump_cc", &Envelope::pump_cc}};

/// Of a vehicle with a propeller.
constexpr std::pair<const char*, double Envelope::*> kDrives[] = {
    {"slowest_m_s", &Envelope::slowest_m_s},
    {"usual_speed_m_s", &Envelope::usual_speed_m_s},
    {"fastest_m_s", &Envelope::fastest_m_s}};

constexpr std::pair<const char*, double EnvironmentModel::*> kWorld[] = {
    {"start_depth_m", &EnvironmentModel::start_depth_m},
    {"surface_depth_m", &EnvironmentModel::surface_depth_m},
    {"slowest_climb_m_s", &EnvironmentModel::slowest_climb_m_s},
    {"turn_s", &EnvironmentModel::turn_s},
    {"depth_error_m", &EnvironmentModel::depth_error_m},
    {"tick_gap_s", &EnvironmentModel::tick_gap_s},
    {"through_water_m_s", &EnvironmentModel::through_water_m_s},
    {"steering_error_m", &EnvironmentModel::steering_error_m},
    {"surface_drift_m_s", &EnvironmentModel::surface_drift_m_s}};

constexpr std::pair<const char*, double Motion::*> kMotion[] = {
    {"pump_rate_cc_s", &Motion::pump_rate_cc_s},
    {"pitch_battery_limit_in", &Motion::pitch_battery_limit_in},
    {"pitch_battery_rate_in_s", &Motion::pitch_battery_rate_in_s},
    {"fin_rate_rad_s", &Motion::fin_rate_rad_s},
    {"trim_pump_per_m3", &Motion::trim_pump_per_m3},
    {"trim_battery_per_m", &Motion::trim_battery_per_m},
    {"pitch_lag_s", &Motion::pitch_lag_s},
    {"yaw_gain_rad_s_m2", &Motion::yaw_gain_rad_s_m2},
    {"yaw_lag_s", &Motion::yaw_lag_s},
    {"speed_lag_s", &Motion::speed_lag_s},
    {"pump_out_j_cc", &Motion::pump_out_j_cc},
    {"pump_out_j_cc_m", &Motion::pump_out_j_cc_m},
    {"pump_in_j_cc", &Motion::pump_in_j_cc}};

constexpr std::pair<const char*, double FlightCoefficients::*> kFlight[] = {
    {"mass_kg", &FlightCoefficients::mass_kg},
    {"reference_area_m2", &FlightCoefficients::reference_area_m2},
    {"drag", &FlightCoefficients::drag},
    {"induced_drag", &FlightCoefficients::induced_drag},
    {"wing_lift", &FlightCoefficients::wing_lift},
    {"hull_lift", &FlightCoefficients::hull_lift},
    {"compressibility_per_Pa", &FlightCoefficients::compressibility_per_pa}};

constexpr std::pair<const char*, double Power::*> kPower[] = {{"capacity_kJ", &Power::capacity_kj},
                                                              {"full_V", &Power::full_V},
                                                              {"empty_V", &Power::empty_V},
                                                              {"hotel_W", &Power::hotel_W}};

/// Sets the fields of `rows`, each above 0.
template <typename T, size_t kCount>
void readInto(TomlReader& reader, const std::pair<const char*, double T::*> (&rows)[kCount],
              T& numbers) {
  for (const auto& [key, field] : rows) {
    numbers.*field = reader.number(key);
    if (!(numbers.*field > 0)) {
      reader.refuse(key, "must be above 0");
    }
  }
}

/// Reads by which of pitch and speed the vehicle is told how to go to a depth.
void readSlope(TomlReader& reader, Envelope& envelope) {
  const auto within = [&](const char* key, double value, double least, double most) {
    if (!(value >= least && value <= most)) {
      reader.refuse(key, "must be between the slowest or shallowest and the fastest or steepest");
    }
  };
  if (reader.numberOr("fastest_m_s", 0) != 0) {
    readInto(reader, kDrives, envelope);
    within("usual_speed_m_s", envelope.usual_speed_m_s, envelope.slowest_m_s, envelope.fastest_m_s);
  } else {
    readInto(reader, kGlides, envelope);
    constexpr double kUsualPitch = 0.4537856055185257;  // 26 degrees
    envelope.usual_pitch_rad = reader.numberOr(
        "usual_pitch_rad",
        std::clamp(kUsualPitch, envelope.shallowest_pitch_rad,
                   std::max(envelope.shallowest_pitch_rad, envelope.steepest_pitch_rad)));
    within("usual_pitch_rad", envelope.usual_pitch_rad, envelope.shallowest_pitch_rad,
           envelope.steepest_pitch_rad);
  }
}

/// A vehicle may have no fin and no pitch battery; `flies`: the simulator turns it by one.
Envelope readEnvelope(TomlReader& reader, bool flies) {
  std::vector<std::string_view> others = {"fin_rad", "battery_in"};
  const bool drives = reader.numberOr("fastest_m_s", 0) != 0;
  if (drives) {
    std::ranges::transform(kDrives, std::back_inserter(others),
                           [](const auto& row) { return row.first; });
  } else {
    std::ranges::transform(kGlides, std::back_inserter(others),
                           [](const auto& row) { return row.first; });
    others.emplace_back("usual_pitch_rad");
  }
  auto envelope = readNumbers(reader, kEnvelope, others);
  readSlope(reader, envelope);
  envelope.fin_rad = reader.numberOr("fin_rad", 0);
  constexpr double kQuarterTurn = 1.5707963267948966;
  if (!(envelope.fin_rad >= 0 && envelope.fin_rad <= kQuarterTurn)) {
    reader.refuse("fin_rad", "must be between 0 and a quarter of a turn");
  }
  if (flies && !drives && envelope.fin_rad == 0) {
    reader.refuse("fin_rad", "must be above 0: the simulator turns the vehicle by its fin");
  }
  envelope.battery_in = reader.numberOr("battery_in", 0);
  if (!(envelope.battery_in >= 0)) {
    reader.refuse("battery_in", "must not be below 0");
  }
  return envelope;
}

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

Motion readMotion(TomlReader& reader, TomlReader& flight) {
  Motion motion = readNumbers<Motion>(reader, kMotion, {"model", "trim_offset", "flight"});
  motion.model = reader.text("model");
  motion.trim_offset = reader.number("trim_offset");
  motion.flight = readNumbers(flight, kFlight);
  return motion;
}

Power readPower(TomlReader& reader) {
  Power power = readNumbers<Power>(reader, kPower, {"sbc_W"});
  power.sbc_W = reader.numberOr("sbc_W", 0);
  if (!(power.sbc_W >= 0)) {
    reader.refuse("sbc_W", "must not be below 0");
  }
  if (!(power.empty_V < power.full_V)) {
    reader.refuse("empty_V", "must be below `full_V`");
  }
  return power;
}

/// Whether missions and C can use `name`.
bool isName(std::string_view name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return !name.empty() && letter(name.front()) && std::ranges::all_of(name, [&](char c) {
    return letter(c) || (c >= '0' && c <= '9') || c == '_';
  });
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
               "power", "sensor"});
  platform.name = reader.text("name");
  if (!isName(platform.name)) {
    reader.refuse("name", "must be letters, digits and `_`, and begin with a letter");
  } else if (platform.name != path.stem()) {
    reader.refuse("name", "must be that of the file: missions find the platform by it");
  }
  platform.description = reader.text("description");
  platform.family = reader.textOr("family", "");
  platform.front_seats = reader.textsOr("front_seats");
  static const toml::table kNone;
  auto part = [&](const toml::node_view<toml::node>& node, const char* title) {
    const toml::table* table = node.as_table();
    return TomlReader(path.string(), table != nullptr ? *table : kNone, title);
  };
  TomlReader envelope = part((*root)["envelope"], "[envelope]");
  platform.envelope = readEnvelope(envelope, root->contains("motion"));
  TomlReader world = part((*root)["world"], "[world]");
  platform.world = readWorld(world);
  TomlReader motion = part((*root)["motion"], "[motion]");
  TomlReader flight = part((*root)["motion"]["flight"], "[motion.flight]");
  TomlReader power = part((*root)["power"], "[power]");
  if (root->contains("motion")) {
    platform.motion = readMotion(motion, flight);
    platform.power = readPower(power);
  } else if (root->contains("power")) {
    reader.refuse("power", "means nothing without [motion]");
  }
  for (const TomlReader* read : {&reader, &envelope, &world, &motion, &flight, &power}) {
    if (read->failure()) {
      return std::unexpected(*read->failure());
    }
  }
  if (auto read = readSensors(path.string(), *root, platform); !read) {
    return std::unexpected(read.error());
  }
  if (platform.seatIsOnBoard()) {
    addSeatSensors(platform);
  }
  return platform;
}

}  // namespace glider::platforms
