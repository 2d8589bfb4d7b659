// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/port_files/port_plan.h"

#include "hooks/extctl/port.h"
#include "hooks/protocol/crc.h"
#include "platforms/load/dictionary.h"
#include "support/diagnostics/ids/vehicle.h"

#include <algorithm>
#include <cctype>

namespace glider::slocum {
namespace {

using hooks::extctl::Port;

/// A vehicle's file names have eight letters and an ending.
std::string shortName(const std::string& name) {
  constexpr size_t kLongest = 8;
  std::string letters;
  for (const char c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
      letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return letters.empty() ? "mission" : letters.substr(0, kLongest);
}

/// A whole number that a 4-byte sensor keeps, never 0, and no b_arg would take for a parameter
/// (1000000 and more).
uint32_t numberOf(std::string_view content) {
  constexpr uint32_t kMost = 999'999;
  const uint32_t crc = hooks::crc32c(reinterpret_cast<const uint8_t*>(content.data()),
                                     static_cast<uint32_t>(content.size()));
  return crc % kMost + 1;
}

/// Of a sensor of the vehicle; hooks::kNoSensor if it lacks it.
uint16_t sensorNumber(const platforms::Platform& platform, std::string_view name) {
  const auto found = std::ranges::find(platform.sensors, name, &platforms::PlatformSensor::name);
  return found == platform.sensors.end() ? hooks::kNoSensor
                                         : static_cast<uint16_t>(found - platform.sensors.begin());
}

ExtctlFile listSensors(const Port& port, const platforms::Platform& platform) {
  ExtctlFile file;
#define PARAMETER(name, sensor, unit) file.parameters.push_back({#sensor, #unit});
#define WRITTEN(name, sensor, unit) file.written.push_back({#sensor, #unit});
#define MARK(name, sensor, unit) file.reported.push_back({#sensor, #unit});
#include "hooks/extctl/port.def"
  for (uint32_t index = hooks::extctl::kFixedSensors; index < port.count(); ++index) {
    const auto& sensor = platform.sensors[port.sensorAt(index)];
    file.reported.push_back({sensor.name, sensor.unit == "1" ? "nodim" : sensor.unit});
  }
  return file;
}

Port portFor(const platforms::Platform& platform, const platforms::Dictionary& dictionary,
             const std::vector<uint16_t>& sensors) {
  std::vector<hooks::Subscription> all = {{.id = sensorNumber(platform, "m_lat")},
                                          {.id = sensorNumber(platform, "m_lon")}};
  for (const uint16_t id : sensors) {
    all.push_back({.id = id});
  }
  all.push_back({.id = hooks::sensorOf(dictionary.get(), kGliderRoleDepth)});
  return {dictionary.get(), all.data(), static_cast<uint32_t>(all.size())};
}

GliderPortMission programFor(std::string_view content, const platforms::Platform& platform,
                             const PortChoice& choice) {
  return {.greatest_depth_m = choice.greatest_depth_m,
          .steepest_pitch_rad = platform.envelope.steepest_pitch_rad,
          .shallowest_pitch_rad = platform.envelope.shallowest_pitch_rad,
          .hold_m = holdOf(platform),
          .program = numberOf(content),
          .latitude = sensorNumber(platform, "m_lat"),
          .longitude = sensorNumber(platform, "m_lon"),
          .depth_state = sensorNumber(platform, "m_depth_state"),
          .mission_modes = choice.release == Release::MissionModes ? 1U : 0U};
}

}  // namespace

/// Twice what the vehicle overshoots: less, and it would turn at the first end of the yo that holds
/// a depth before it has turned at the other.
double holdOf(const platforms::Platform& platform) {
  return 2 * platform.envelope.inflection_overshoot_m;
}

support::Result<PortPlan> planPort(const std::string& name, std::string_view content,
                                   const platforms::Platform& platform,
                                   const std::vector<uint16_t>& sensors, const PortChoice& choice) {
  const platforms::Dictionary dictionary(platform);
  const Port port = portFor(platform, dictionary, sensors);
  const uint32_t needed = hooks::extctl::kFixedSensors + static_cast<uint32_t>(sensors.size());
  if (!port.fits() || port.count() > choice.most_sensors) {
    return support::fail(support::diagnostics::portTooSmall, needed, choice.most_sensors);
  }
  PortPlan plan{.mission = name,
                .file = shortName(name),
                .choice = choice,
                .port = programFor(content, platform, choice),
                .extctl = listSensors(port, platform),
                .overshoot_m = platform.envelope.inflection_overshoot_m,
                .overdepth_m = choice.greatest_depth_m +
                               kAbortsBelow * platform.envelope.inflection_overshoot_m};
  plan.extctl.baud = choice.baud;
  return plan;
}

}  // namespace glider::slocum
