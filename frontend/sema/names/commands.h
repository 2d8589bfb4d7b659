// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/sema/names/names.h"
#include "platforms/load/platform.h"

#include <string>
#include <string_view>
#include <vector>

namespace glider::frontend {

/// A command that a statement can give to the vehicle.
struct VehicleCommand {
  ir::Command command;
  std::string name;
  Signature signature;
};

/// The commands of ir/core/commands.def that a vehicle has, in its order: one that takes a speed to
/// go to a depth, or one that takes a pitch.
const std::vector<VehicleCommand>& vehicleCommands(const platforms::Platform& platform);

/// Whether `name` is a command of some vehicle.
bool isCommandName(std::string_view name);

}  // namespace glider::frontend
