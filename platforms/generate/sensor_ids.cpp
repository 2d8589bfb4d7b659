// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Writes the C header of a platform's sensor numbers, so that code on board and the platform file
// never differ:
//   glider_sensor_ids platforms/slocum.toml generated/platforms/slocum_sensors.h

#include "platforms/load/platform.h"
#include "support/files.h"

#include <cctype>
#include <cstdio>

namespace {

std::string upper(std::string text) {
  for (char& c : text) {
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return text;
}

/// FNV-1a over names and widths: two programs with the same number mean the same sensors.
uint32_t dictionaryHash(const glider::platforms::Platform& platform) {
  uint32_t hash = 2166136261U;
  auto mix = [&](unsigned char byte) { hash = (hash ^ byte) * 16777619U; };
  for (const auto& sensor : platform.sensors) {
    for (const char c : sensor.name) {
      mix(static_cast<unsigned char>(c));
    }
    mix(0);
    mix(sensor.bytes);
  }
  return hash;
}

/// The limits of the hull as constants, for code that must not be told others.
std::string hull(const glider::platforms::Envelope& envelope) {
  return fmt::format(
      "/* The hull: m, rad, rad, m/s, cc to either side */\n"
      "#define GLIDER_HULL_GREATEST_DEPTH_M {}\n#define GLIDER_HULL_STEEPEST_PITCH_RAD {}\n"
      "#define GLIDER_HULL_SHALLOWEST_PITCH_RAD {}\n#define GLIDER_HULL_VERTICAL_RATE_M_S {}\n"
      "#define GLIDER_HULL_PUMP_CC {}\n\n",
      envelope.greatest_depth_m, envelope.steepest_pitch_rad, envelope.shallowest_pitch_rad,
      envelope.vertical_rate_m_s, envelope.pump_cc);
}

std::string header(const glider::platforms::Platform& platform) {
  const std::string guard = fmt::format("GLIDER_GENERATED_{}_SENSORS_H", upper(platform.name));
  std::string out =
      fmt::format("/* Generated from platforms/{}.toml. */\n#ifndef {}\n#define {}\n\n",
                  platform.name, guard, guard);
  out += "/* X(number, name, bytes in the sensor array, 1 if the science computer has it) */\n";
  out += "#define GLIDER_SENSOR_LIST(X) \\\n";
  for (const auto& s : platform.sensors) {
    out += fmt::format("  X({}, {}, {}, {}){}\n", s.id, s.name, s.bytes,
                       s.computer == glider::platforms::Computer::Science ? 1 : 0,
                       s.id + 1U == platform.sensors.size() ? "" : " \\");
  }
  out +=
      "\n/* X(number, name, factor to SI units, lowest and highest plausible value, stale after s, "
      "1 "
      "if ddmm.mmmm) */\n#define GLIDER_SENSOR_TABLE(X) \\\n";
  for (const auto& s : platform.sensors) {
    out += fmt::format("  X({}, {}, {}, {}, {}, {}, {}){}\n", s.id, s.name, s.to_si, s.lowest,
                       s.highest, s.stale_after_s,
                       s.kind == glider::platforms::SensorKind::Quantity ? 0 : 1,
                       s.id + 1U == platform.sensors.size() ? "" : " \\");
  }
  out += "\n/* X(number, at most once in so many flight cycles, dead band) */\n";
  out += "#define GLIDER_SENSOR_REPORTS(X) \\\n";
  for (const auto& s : platform.sensors) {
    out += fmt::format("  X({}, {}, {}){}\n", s.id, s.every_s / platform.envelope.cycle_s,
                       s.dead_band, s.id + 1U == platform.sensors.size() ? "" : " \\");
  }
  out += "\nenum GliderSensorNumber {\n";
  for (const auto& s : platform.sensors) {
    out += fmt::format("  GLIDER_{} = {},\n", upper(s.name), s.id);
  }
  out += fmt::format("  GLIDER_SENSOR_COUNT = {}\n}};\n\n", platform.sensors.size());
  out += hull(platform.envelope);
  out +=
      fmt::format("#define GLIDER_DICTIONARY_HASH 0x{:08X}u\n\n#endif\n", dictionaryHash(platform));
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: glider_sensor_ids PLATFORM.toml HEADER.h\n");
    return 2;
  }
  const auto platform = glider::platforms::loadPlatform(argv[1]);
  if (!platform) {
    std::fprintf(stderr, "%s\n", platform.error().message.c_str());
    return 1;
  }
  const auto written = glider::support::writeFileAtomically(argv[2], header(*platform));
  if (!written) {
    std::fprintf(stderr, "%s\n", written.error().message.c_str());
    return 2;
  }
  return 0;
}
