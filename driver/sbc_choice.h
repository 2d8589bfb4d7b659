// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "driver/compilation.h"
#include "driver/launch_choice.h"
#include "simulator/sbc_port.h"
#include "support/result.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace glider::driver {

/// Compiles the mission for this process and loads it; `user_code` is what --link names.
support::Result<std::unique_ptr<simulator::SbcPort>> sbcInProcess(
    const Compilation& compilation, const LaunchChoice& launch,
    const std::vector<std::string>& user_code);

/// Builds the mission's binary for `board` into `folder` as `name`-`board` and starts it behind a
/// pseudo-terminal, under the board's emulator if it has one.
support::Result<std::unique_ptr<simulator::SbcPort>> sbcOnBoard(
    const Compilation& compilation, const LaunchChoice& launch,
    const std::vector<std::string>& user_code, const std::string& board, const std::string& name,
    const std::filesystem::path& folder);

/// Starts a program that somebody has built, with `--port PTY` as its only arguments.
support::Result<std::unique_ptr<simulator::SbcPort>> sbcProgram(const std::string& program);

}  // namespace glider::driver
