// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/abi/port_mission.h"

#include <llvm/IR/Module.h>

namespace glider::codegen {

/// Adds `port` to a module as the constant `gliderPort`, which the runtime's part for the vehicle's
/// port reads.
void addPortMission(llvm::Module& module, const GliderPortMission& port);

}  // namespace glider::codegen
