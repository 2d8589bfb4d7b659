// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/flight/mission_variables.h"

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
  for (const slocum::Setting& sensor : mission.sensors) {
    values_[sensor.name] = sensor.value;
  }
}

double MissionVariables::get(std::string_view name) const {
  const auto found = values_.find(name);
  return found == values_.end() ? 0 : found->second;
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
