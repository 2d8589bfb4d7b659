// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/hull.h"
#include "platforms/slocum_sensors.h"
#include "simulator/simulator.h"
#include "simulator/vehicle/vehicle_model.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::simulator {
namespace {

/// The code here was built with the numbers of one platform file: the one given must have the same.
support::Result<void> checkSensors(const platforms::Platform& platform) {
  struct Wanted {
    uint16_t id;
    const char* name;
    uint8_t bytes;
  };
#define GLIDER_WANTED(number, name, bytes, science) Wanted{number, #name, bytes},
  constexpr Wanted kAll[] = {GLIDER_SENSOR_LIST(GLIDER_WANTED)};
#undef GLIDER_WANTED
  for (const platforms::PlatformSensor& sensor : platform.sensors) {
    const bool known =
        std::ranges::any_of(kAll, [&](const Wanted& wanted) { return wanted.name == sensor.name; });
    if (!known) {
      return support::fail(support::DiagnosticId::sensorNotSimulated, platform.name, sensor.name);
    }
  }
  for (const Wanted& wanted : kAll) {
    const bool same = wanted.id < platform.sensors.size() &&
                      platform.sensors[wanted.id].name == wanted.name &&
                      platform.sensors[wanted.id].bytes == wanted.bytes;
    if (!same) {
      return support::fail(support::DiagnosticId::platformLacksSensor, platform.name, wanted.name);
    }
  }
  return {};
}

/// The simulator has a model that moves it.
support::Result<void> checkMotion(const platforms::Platform& platform) {
  const std::string file = fmt::format("platform `{}`", platform.name);
  if (!platform.motion) {
    return support::fail(support::DiagnosticId::badDataFile, file,
                         "the simulator cannot fly this vehicle: its file has no [motion]");
  }
  if (!isModel(platform.motion->model)) {
    return support::fail(support::DiagnosticId::badDataFile, file,
                         fmt::format("the simulator cannot fly this vehicle: it has no model `{}`, "
                                     "only `glider`",
                                     platform.motion->model));
  }
  return {};
}

/// hookbeh in the simulator keeps to the hull that it was built for, whatever the platform says.
support::Result<void> checkHull(const platforms::Platform& platform) {
  const platforms::Envelope& hull = platform.envelope;
  struct Number {
    const char* name;
    double value, built;
  };
  const Number numbers[] = {
      {"greatest_depth_m", hull.greatest_depth_m, hooks::kHull.greatest_depth_m},
      {"steepest_pitch_rad", hull.steepest_pitch_rad, hooks::kHull.steepest_pitch_rad},
      {"shallowest_pitch_rad", hull.shallowest_pitch_rad, hooks::kHull.shallowest_pitch_rad},
      {"vertical_rate_m_s", hull.vertical_rate_m_s, hooks::kHull.vertical_rate_m_s},
      {"pump_cc", hull.pump_cc, hooks::kHull.pump_cc}};
  for (const auto& [name, value, built] : numbers) {
    if (value != built) {
      return support::fail(
          support::DiagnosticId::badDataFile, fmt::format("platform `{}`", platform.name),
          fmt::format("the simulator cannot fly this vehicle: its {} is {}, and hookbeh in the "
                      "simulator is built for {}; simulate with platform `slocum`",
                      name, value, built));
    }
  }
  return {};
}

}  // namespace

support::Result<void> checkPlatform(const platforms::Platform& platform) {
  for (const auto check : {checkSensors, checkMotion, checkHull}) {
    if (auto checked = check(platform); !checked) {
      return checked;
    }
  }
  return {};
}

}  // namespace glider::simulator
