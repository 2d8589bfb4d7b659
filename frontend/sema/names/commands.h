// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/sema/names/names.h"

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

/// The commands of ir/core/commands.def, in its order.
const std::vector<VehicleCommand>& vehicleCommands();

}  // namespace glider::frontend
