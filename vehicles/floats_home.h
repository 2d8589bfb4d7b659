// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/campaign/floating_judge.h"
#include "simulator/campaign/promises.h"
#include "simulator/scenario/scenario.h"
#include "vehicles/own_mission.h"

#include <memory>
#include <string>

namespace glider::vehicles {

/// What happens to a vehicle that floats up when the SBC is silent.
struct Floats {
  double timeout_s = 0;  ///< from the SBC's last command until it loses control
  std::string first;     ///< what the vehicle then does: "stops its propeller"
  std::string timeout;   ///< what the time is: "the time-out of the plan"
};

/// Upper bound from the SBC's last command until it loses control, s: the last one may have been on
/// its way.
double letsGoWithin(double timeout_s, const platforms::Platform& platform);

/// What such a vehicle flies by itself: nothing.
std::unique_ptr<OwnMission> floatsHome(const Floats& floats);

/// What its flights are checked for.
simulator::FloatingPromise promiseOf(double timeout_s, const platforms::Platform& platform);

/// Whether that check expects anything with a fault of this kind (Vehicle::promises).
bool promisesOfFloating(simulator::FaultKind kind, const simulator::Scenario& scenario);

}  // namespace glider::vehicles
