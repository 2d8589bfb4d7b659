// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/codegen.h"

#include <cstdint>
#include <expected>
#include <string>

namespace glider::codegen {

/// What a mission needs of a board at most, measured on its linked executable.
struct Budget {
  uint64_t executable_bytes = 0;  ///< of the stripped file
  uint64_t memory_bytes = 0;      ///< of code and data once it is loaded, without the stack
  uint64_t data_bytes = 0;        ///< that part of memory_bytes which is written to
  uint64_t context_bytes = 0;     ///< that part of data_bytes of which checkpoints are made
  /// Of the stack, from the program's first instruction on, at most; or why there is no bound.
  std::expected<uint64_t, std::string> stack_bytes;
  /// From a frame's readings to the command (gliderStep), at most; or why there is no bound.
  std::expected<uint64_t, std::string> tick_instructions;
};

/// Builds the mission for `board` as `glidercc build` does and measures that. `mission` is as it is
/// compiled: optimised, if it is to be. README.md says how. Errors as linkExecutable's, but a file
/// that is too large is none.
support::Result<Budget> measureBudget(const Input& input, const platforms::Board& board,
                                      const CodegenOptions& options);

}  // namespace glider::codegen
