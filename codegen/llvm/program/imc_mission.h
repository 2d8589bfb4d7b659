// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/abi/imc_mission.h"

#include <llvm/IR/Module.h>

namespace glider::codegen {

/// Adds `imc` to a module as the constant `gliderImc`, which the runtime's part for a vehicle that
/// speaks IMC reads.
void addImcMission(llvm::Module& module, const GliderImcMission& imc);

}  // namespace glider::codegen
