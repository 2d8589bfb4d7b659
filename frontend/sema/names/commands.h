// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/sema/names/names.h"

#include <string>
#include <string_view>
#include <vector>

namespace glider::frontend {

/// What a statement can make the vehicle do.
struct VehicleCommand {
  ir::Command command;
  std::string name;
  Signature signature;
};

/// Those of ir/core/commands.def, in its order.
const std::vector<VehicleCommand>& vehicleCommands();

}  // namespace glider::frontend
