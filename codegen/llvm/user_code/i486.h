// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/board.h"
#include "support/result.h"

#include <llvm/Object/ELFObjectFile.h>

#include <string>

namespace glider::codegen {

/// Looks through an i386 object's code for instructions that came after the 486, of which a board
/// with one dies. GL4010, GL4008 if it cannot be read.
support::Result<void> checkI486(const llvm::object::ELFObjectFileBase& object,
                                const std::string& name, const platforms::Board& board);

}  // namespace glider::codegen
