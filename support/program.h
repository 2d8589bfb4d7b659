// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/result.h"

#include <string>
#include <string_view>
#include <sys/types.h>
#include <vector>

namespace glider::support {

/// What a program that has ended wrote to its standard output, and its exit code.
struct ProgramOutput {
  std::string text;
  int exit_code = 0;  ///< 128 + the signal if one ended it
};

/// Starts `command` (the program, looked up in PATH, and its arguments) with these descriptors as
/// its standard input and output; it ends with this process. Returns the process, or -1 with errno
/// set.
pid_t startProgram(const std::vector<std::string>& command, int input, int output);

/// Starts `command` with `input` as its standard
/// input until it ends. GL9380 if it cannot be started.
Result<ProgramOutput> runProgram(const std::vector<std::string>& command, std::string_view input);

}  // namespace glider::support
