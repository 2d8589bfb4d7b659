// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/lower/lowering.h"

#include <llvm/IR/GlobalVariable.h>

namespace glider::codegen {

/// What a debugger calls the parts of a running mission's memory, under the names of the mission:
/// its variables and parameters, the sensors (their readings of this tick), `missiontime`, `state`
/// with the states' names, `callers`, and `windows` by kind and line. What belongs to states is
/// in the struct `states`. A number's type is its SI unit (positions: degrees). They are
/// the same at every level of optimisation, because all of it is kept in memory between functions.
void describeMemory(Lowering& lowering, llvm::GlobalVariable& memory);

}  // namespace glider::codegen
