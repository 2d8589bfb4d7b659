// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <llvm/IR/Module.h>
#include <llvm/Target/TargetMachine.h>

namespace glider::codegen {

/// Optimises in place at `level` (0 to 3; 3 is for a whole program, 2 for a mission with imported
/// bodies, which are dropped at the end). No pass may change the meaning of floating-point
/// arithmetic.
void optimise(llvm::Module& module, llvm::TargetMachine& machine, int level);

}  // namespace glider::codegen
