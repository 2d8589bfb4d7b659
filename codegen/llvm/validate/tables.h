// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/validation.h"
#include "ir/core/mission.h"

#include <llvm/IR/Module.h>

namespace glider::codegen::validate {

/// The field of a constant record, and the constant behind a pointer; null if it is null.
const llvm::Constant* fieldOf(const llvm::Constant& record, unsigned field);
const llvm::Constant* behind(const llvm::Constant* pointer);
/// A field that is a whole number.
uint64_t wordOf(const llvm::Constant& record, unsigned field);

/// Whether the constant that describes a state to the runtime says what the mission says of it:
/// its cases' transitions, what it logs.
Validated compareState(const ir::Mission& mission, ir::StateId state,
                       const llvm::Constant& described);

/// The same of the constant that describes the mission: its cases of `always`, its sensors, how
/// many there are of what.
Validated compareMission(const ir::Mission& mission, uint32_t stack_depth,
                         const llvm::Constant& described);

}  // namespace glider::codegen::validate
