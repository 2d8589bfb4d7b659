// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/board.h"
#include "support/result.h"

#include <llvm/Target/TargetMachine.h>

#include <memory>

namespace glider::codegen {

enum class ProgramKind : uint8_t { Executable, SharedObject };

/// The code generator for a board at `level` (0 to 3). GL4002 if the board's machine is unknown.
support::Result<std::unique_ptr<llvm::TargetMachine>> makeMachine(const platforms::Board& board,
                                                                  int level, ProgramKind kind);

}  // namespace glider::codegen
