// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/board.h"
#include "platforms/load/platform.h"
#include "support/result.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace glider::compiler {

/// The names of all targets that this installation can build for, sorted: the folders of
/// share/glidercc/boards.
std::vector<std::string> targetNames();
/// The folder that holds what `target` is linked with.
std::filesystem::path boardDirectory(const std::string& target);
/// Loads target `name`; GL4001 (with the names of the targets) if there is none of that name.
support::Result<platforms::Board> loadTarget(const std::string& name);
/// Loads the SBC that is usually on a vehicle; empty: none is known.
support::Result<std::optional<platforms::Board>> usualBoard(const platforms::Platform& platform);
/// What that draws; empty: its file does not say, or none is known.
support::Result<std::optional<platforms::BoardPower>> usualBoardPower(
    const platforms::Platform& platform);

}  // namespace glider::compiler
