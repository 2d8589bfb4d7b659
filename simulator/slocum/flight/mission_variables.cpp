// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/flight/mission_variables.h"

#include <ranges>

namespace glider::simulator {
namespace {

std::string parameterName(int number) {
  return std::string("u_mission_param_") + static_cast<char>('a' + number);
}

}  // namespace

MissionVariables::MissionVariables(const slocum::MissionFile& mission) {
  for (int number = 0; number < slocum::kMissionParameters; ++number) {
    values_.emplace(parameterName(number), 0);
  }
  for (const slocum::Setting& sensor : mission.vehicle_sensors) {
    values_[sensor.name] = sensor.value;
  }
  for (const slocum::Setting& sensor : mission.sensors) {
    values_[sensor.name] = sensor.value;
  }
  // sensors_in sets its own once, when the mission starts: what is put later counts more.
  for (const slocum::BehaviourBlock& block : mission.behaviours | std::views::reverse) {
    if (block.name == "sensors_in" && !block.lacks_file) {
      for (const slocum::Setting& given : block.arguments) {
        values_[given.name] = given.value;
      }
    }
  }
}

double MissionVariables::get(std::string_view name) const {
  const auto found = values_.find(name);
  return found == values_.end() ? 0 : found->second;
}

std::optional<double> MissionVariables::find(std::string_view name) const {
  const auto found = values_.find(name);
  if (found == values_.end()) {
    return std::nullopt;
  }
  const auto number = slocum::missionParameter(found->second);
  return number ? *parameter(*number) : found->second;
}

const double* MissionVariables::parameter(int number) const {
  return &values_.find(parameterName(number))->second;
}

Argument::Argument(double given, const MissionVariables& variables)
    : value_(given), parameter_(nullptr) {
  if (const auto number = slocum::missionParameter(given)) {
    parameter_ = variables.parameter(*number);
  }
}

}  // namespace glider::simulator
