// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "platforms/load/dictionary.h"
#include "simulator/family/family.h"
#include "simulator/simulator.h"
#include "simulator/vehicle/vehicle_model.h"
#include "support/diagnostics/ids/vehicle.h"

#include <fmt/format.h>

#include <string_view>

namespace glider::simulator {
namespace {

/// Checks that the simulator has a model that moves it.
support::Result<void> checkMotion(const platforms::Platform& platform) {
  const std::string file = fmt::format("platform `{}`", platform.name);
  if (!platform.motion) {
    return support::fail(support::diagnostics::badDataFile, file,
                         "the simulator cannot fly this vehicle: its file has no [motion]");
  }
  if (!isModel(platform.motion->model)) {
    return support::fail(support::diagnostics::badDataFile, file,
                         fmt::format("the simulator cannot fly this vehicle: it has no model `{}`, "
                                     "{}",
                                     platform.motion->model, knownModels()));
  }
  return {};
}

}  // namespace

support::Result<void> checkPlatform(const platforms::Platform& platform) {
  if (auto roles = platforms::checkRoles(platform); !roles) {
    return roles;
  }
  const Family* family = familyOf(platform);
  if (family == nullptr) {
    return support::fail(
        support::diagnostics::badDataFile, fmt::format("platform `{}`", platform.name),
        fmt::format("the simulator cannot fly this vehicle: its file names no `family` that it "
                    "knows, {}",
                    knownFamilies()));
  }
  if (const auto missing = family->missing_sensor(platform); !missing.empty()) {
    return support::fail(support::diagnostics::platformLacksSensor, platform.name, missing);
  }
  return checkMotion(platform);
}

}  // namespace glider::simulator
