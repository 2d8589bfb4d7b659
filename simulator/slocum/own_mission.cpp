// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/own_mission.h"

#include "support/check.h"

namespace glider::simulator {

SlocumMission& slocumMissionOf(Scenario& scenario) {
  if (!scenario.own.has_value()) {
    scenario.own = SlocumMission();
  }
  auto* own = std::any_cast<SlocumMission>(&scenario.own);
  CHECK(own != nullptr, "a scenario for another family of vehicles");
  return *own;
}

const SlocumMission& slocumMissionOf(const Scenario& scenario) {
  static const SlocumMission kNone;
  const auto* own = std::any_cast<SlocumMission>(&scenario.own);
  CHECK(own != nullptr || !scenario.own.has_value(), "a scenario for another family of vehicles");
  return own != nullptr ? *own : kNone;
}

}  // namespace glider::simulator
