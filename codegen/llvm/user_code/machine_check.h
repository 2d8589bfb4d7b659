// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/board.h"
#include "support/result.h"

#include <llvm/Object/ELFObjectFile.h>

#include <string>

namespace glider::codegen {

/// "32-bit x86" for the triple of a board or a module.
std::string machineOf(const std::string& triple);

/// Refuses an object that a board cannot run: for another machine, for a later processor of its
/// kind (ARM objects declare it, x86 objects are searched for instructions that the 486 lacks), or
/// with floating-point arguments in registers that the board does not have. GL4008, GL4009, GL4010.
support::Result<void> checkMachine(const llvm::object::ELFObjectFileBase& object,
                                   const std::string& name, const platforms::Board& board);

}  // namespace glider::codegen
