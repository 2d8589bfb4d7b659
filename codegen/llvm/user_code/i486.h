// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/board.h"
#include "support/result.h"

#include <llvm/Object/ELFObjectFile.h>

#include <string>

namespace glider::codegen {

/// Searches an i386 object's code for instructions later than the 486, on which a program fails on
/// a board with a 486. GL4010, GL4008 if it cannot be read.
support::Result<void> checkI486(const llvm::object::ELFObjectFileBase& object,
                                const std::string& name, const platforms::Board& board);

}  // namespace glider::codegen
