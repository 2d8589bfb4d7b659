// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

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

}  // namespace glider::codegen
