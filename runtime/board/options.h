// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/abi/glider_abi.h"

#include <stdint.h>

/// The command line of a mission's program.
namespace glider::runtime {

struct Options {
  enum class Wish : uint8_t { Fly, Help, Version, Wrong };
  Wish wish = Wish::Fly;
  const char* wrong = "";        ///< the argument that is not understood
  const char* wrong_value = "";  ///< the value after it, if it is an option
  const char* port = nullptr;    ///< null: the board's default
  uint32_t baud = 115200;
  bool stdio = false;               ///< the protocol runs over standard input and output
  const char* log = nullptr;        ///< null: no log
  uint32_t log_limit = 32U << 20U;  ///< bytes after which a new one begins
  static constexpr uint32_t kLeastLogLimit = 4096;  ///< more than its head usually takes
  const char* checkpoints = nullptr;                ///< the file of checkpoints; null: none
  const char* parameters = nullptr;                 ///< a file of parameters; null: none
  const char* sleep = nullptr;  ///< the file by which the board is put to sleep; null: it stays on
  static constexpr uint32_t kMostSettings = GLIDER_MOST_PARAMETERS;
  const char* settings[kMostSettings] = {};  ///< of --set, in order
  uint32_t setting_count = 0;
};

Options readOptions(int argc, char** argv);

}  // namespace glider::runtime
