// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/dock/played_vehicle.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace glider::slocum {
namespace {

/// The longest line of the vendor's port.
constexpr size_t kMostLine = 820;
constexpr uint32_t kPromptCycles = 3;
/// As long as the program would need to take control, and more.
constexpr uint32_t kOtherCycles = 8;
/// Of the own mission: the program has written everything by then.
constexpr uint32_t kRestartAt = 16;
constexpr uint32_t kLastCycles = 4;

/// A reading of a vehicle that floats in the sea off New Jersey.
double readingOf(const platforms::PlatformSensor& sensor) {
  constexpr double kLatitude = 3910, kLongitude = -7346, kTemperature = 15;
  const double usual = sensor.kind == platforms::SensorKind::Latitude    ? kLatitude
                       : sensor.kind == platforms::SensorKind::Longitude ? kLongitude
                       : sensor.unit == "degC"                           ? kTemperature
                                                                         : 0;
  return std::clamp(usual, sensor.lowest, sensor.highest);
}

double valueOf(const std::string& name, const DockCycle& cycle, const DockSetup& setup) {
  const bool own = cycle.scene == DockScene::OwnMission;
  const bool flies = own || cycle.scene == DockScene::OtherMission;
  if (name == "u_mission_param_l") {
    return own || cycle.scene == DockScene::PromptAgain ? setup.plan.port.program
                                                        : otherProgram(setup.plan.port.program);
  }
  if (name == "x_in_gliderdos") {
    return flies ? 0 : 1;
  }
  if (name == "m_present_time" || name == "sci_m_present_time") {
    return cycle.clock_s;
  }
  if (name == "m_present_secs_into_mission") {
    return cycle.mission_s;
  }
  const platforms::PlatformSensor* sensor = setup.platform.find(name);
  return sensor != nullptr ? readingOf(*sensor) : 0;
}

}  // namespace

uint32_t otherProgram(uint32_t program) {
  return program == 1 ? 2 : program - 1;
}

std::vector<DockCycle> playCycles(uint32_t count, double clock_s) {
  std::vector<DockCycle> cycles;
  double begun_s = clock_s;
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t own_from = kPromptCycles + kOtherCycles;
    DockCycle cycle;
    cycle.scene = i < kPromptCycles                 ? DockScene::Prompt
                  : i < own_from                    ? DockScene::OtherMission
                  : i + kLastCycles < count         ? DockScene::OwnMission
                  : count <= own_from + kLastCycles ? DockScene::OwnMission
                                                    : DockScene::PromptAgain;
    cycle.clock_s = clock_s + i * kCycleSecs;
    begun_s = i == kPromptCycles || i == own_from ? cycle.clock_s : begun_s;
    cycle.mission_s = cycle.clock_s - begun_s;
    cycle.restarts_port = i == own_from + kRestartAt;
    cycles.push_back(cycle);
  }
  return cycles;
}

std::vector<std::string> reportOf(const DockCycle& cycle, const DockSetup& setup) {
  const std::vector<ExtctlSensor> sensors = setup.sensors.sensors();
  const size_t first = setup.sensors.parameters.size() + setup.sensors.written.size();
  std::vector<std::string> bodies;
  std::string body;
  for (size_t index = first; index < sensors.size(); ++index) {
    const std::string pair =
        fmt::format(",{}:{:.12f}", index, valueOf(sensors[index].name, cycle, setup));
    if (body.size() + pair.size() > kMostLine) {
      bodies.push_back("SD" + std::exchange(body, {}));
    }
    body += pair;
  }
  bodies.push_back("SD" + body);
  return bodies;
}

}  // namespace glider::slocum
