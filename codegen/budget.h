// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <expected>
#include <string>

namespace glider::codegen {

/// Upper bounds of what a mission needs of a board, measured on its linked executable.
struct Budget {
  uint64_t executable_bytes = 0;  ///< of the stripped file
  uint64_t memory_bytes = 0;      ///< of code and data once it is loaded, without the stack
  uint64_t data_bytes = 0;        ///< the part of memory_bytes that is written to
  uint64_t context_bytes = 0;     ///< the part of data_bytes that checkpoints contain
  /// Upper bound of the stack, from the program's first instruction on; or why there is none.
  std::expected<uint64_t, std::string> stack_bytes;
  /// Upper bound from a frame's readings to the command (gliderStep); or why there is none.
  std::expected<uint64_t, std::string> tick_instructions;
};

}  // namespace glider::codegen
