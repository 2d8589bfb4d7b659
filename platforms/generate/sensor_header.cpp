// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "platforms/generate/sensor_header.h"

#include "platforms/load/dictionary.h"

#include <fmt/format.h>

#include <cctype>

namespace glider::platforms {
namespace {

std::string upper(std::string text) {
  for (char& c : text) {
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return text;
}

/// The number in GliderEncoding of runtime/abi/glider_abi.h.
int encoding(const PlatformSensor& sensor) {
  if (sensor.kind != SensorKind::Quantity) {
    return 1;
  }
  return sensor.magnetic ? 2 : 0;
}

/// The limits of the hull as constants, for code that must not be given other limits.
std::string hull(const Envelope& envelope) {
  return fmt::format(
      "/* The hull: m, rad, rad, m/s; cc, rad and in to either side */\n"
      "#define GLIDER_HULL_GREATEST_DEPTH_M {}\n#define GLIDER_HULL_STEEPEST_PITCH_RAD {}\n"
      "#define GLIDER_HULL_SHALLOWEST_PITCH_RAD {}\n#define GLIDER_HULL_VERTICAL_RATE_M_S {}\n"
      "#define GLIDER_HULL_PUMP_CC {}\n#define GLIDER_HULL_FIN_RAD {}\n"
      "#define GLIDER_HULL_BATTERY_IN {}\n\n",
      envelope.greatest_depth_m, envelope.steepest_pitch_rad, envelope.shallowest_pitch_rad,
      envelope.vertical_rate_m_s, envelope.pump_cc, envelope.fin_rad, envelope.battery_in);
}

/// The dictionary for software that builds the hooks into the vehicle.
std::string dictionary(const Platform& platform) {
  const Dictionary whole(platform);
  const GliderDictionary& d = whole.get();
  std::string out =
      "/* In one source file, with this defined before: the dictionary that the hooks are given. "
      "*/\n"
      "#if (defined(GLIDER_DEFINE_DICTIONARY) || defined(GLIDER_DEFINE_VEHICLE)) && "
      "!defined(GLIDER_DICTIONARY_DEFINED)\n#define GLIDER_DICTIONARY_DEFINED\n"
      "#include \"hooks/protocol/dictionary.h\"\n\n"
      "static const GliderSensorFormat gliderSensorFormats[] = {\n";
  for (uint32_t i = 0; i < d.count; ++i) {
    const GliderSensorFormat& f = d.sensors[i];
    out += fmt::format("  {{{}, {}, {}, {}, 0}},\n", f.dead_band, f.bytes, f.every, f.science);
  }
  out += "};\nstatic const uint32_t gliderSensorRoles[] = {";
  for (uint32_t i = 0; i < kGliderRoleCount; ++i) {
    const uint32_t number = d.roles[i];
    out += fmt::format("{}{}", i == 0 ? "" : ", ",
                       number == GLIDER_NO_SENSOR ? "GLIDER_NO_SENSOR" : std::to_string(number));
  }
  return out + fmt::format(
                   "}};\nstatic const GliderDictionary gliderDictionary = {{"
                   "gliderSensorFormats, gliderSensorRoles, {}, 0x{:08X}u}};\n#endif\n\n",
                   d.count, d.hash);
}

/// The vehicle for the runtime of a mission in C.
std::string vehicle(const Platform& platform) {
  std::string out =
      "/* In one source file of a mission in C, with this defined before: the vehicle that it is "
      "for. */\n"
      "#if defined(GLIDER_DEFINE_VEHICLE) && !defined(GLIDER_VEHICLE_DEFINED)\n"
      "#define GLIDER_VEHICLE_DEFINED\n#include \"runtime/c/vehicle.h\"\n\n"
      "static const GliderSensorInfo gliderSensorInfos[] = {\n";
  for (const auto& s : platform.sensors) {
    out += fmt::format("  {{\"{}\", 0, {}, {}, {}, {}, {}, {}}},\n", s.name, s.to_si, s.lowest,
                       s.highest, s.stale_after_s, s.id, encoding(s));
  }
  return out +
         "};\nconst GliderVehicle gliderVehicle = {&gliderDictionary, gliderSensorInfos};\n"
         "#endif\n";
}

}  // namespace

std::string sensorHeader(const Platform& platform) {
  const std::string guard = fmt::format("GLIDER_GENERATED_{}_SENSORS_H", upper(platform.name));
  std::string out =
      fmt::format("/* Generated from platforms/{}.toml. */\n#ifndef {}\n#define {}\n\n",
                  platform.name, guard, guard);
  out += "enum GliderSensorNumber {\n";
  for (const auto& s : platform.sensors) {
    out += fmt::format("  GLIDER_{} = {},\n", upper(s.name), s.id);
  }
  out += fmt::format("  GLIDER_SENSOR_COUNT = {}\n}};\n\n", platform.sensors.size());
  out += hull(platform.envelope);
  out += "#endif\n\n";
  out += dictionary(platform);
  out += vehicle(platform);
  return out;
}

}  // namespace glider::platforms
