// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/scratch_folder.h"
#include "platforms/load/board.h"
#include "support/result.h"

#include <string>

namespace glider::codegen {

/// The highest optimisation level for bitcode and its callers, as -O2.
inline constexpr int kUserCodeLevel = 2;

/// The object of a bitcode file's `content` for the board's own processor, even if the file names
/// another. GL4009 if it is for another machine, GL4012 if it cannot be compiled.
support::Result<std::string> compileBitcode(const std::string& name, const std::string& content,
                                            const platforms::Board& board,
                                            const ScratchFolder& scratch);

}  // namespace glider::codegen
