// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/board.h"
#include "support/result.h"

#include <llvm/Object/ELFObjectFile.h>

#include <string>

namespace glider::codegen {

/// Searches an object for ARM in 64 bits, which does not say for which processor it was compiled:
/// for instructions that the board's lacks (GL4010), and for fused multiplications, whose results
/// other boards do not have (GL4017). GL4008 if it cannot be read.
support::Result<void> checkArmv8(const llvm::object::ELFObjectFileBase& object,
                                 const std::string& name, const platforms::Board& board);

}  // namespace glider::codegen
