// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/abi/recon_mission.h"

#include <llvm/IR/Module.h>

namespace glider::codegen {

/// Adds `recon` to a module as the constant `gliderRecon`, which the runtime's part for a vehicle
/// that speaks RECON reads.
void addReconMission(llvm::Module& module, const GliderReconMission& recon);

}  // namespace glider::codegen
