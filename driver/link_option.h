// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/user_code/user_code.h"
#include "driver/compilation.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace glider::driver {

/// Adds --link FILE to `command`.
void addLinkOption(CLI::App& command, std::vector<std::string>& files);

/// What --link names, checked for the mission and the board. Errors as codegen::UserCode::load.
support::Result<codegen::UserCode> loadUserCode(const std::vector<std::string>& files,
                                                const Compilation& compilation,
                                                const platforms::Board& board);

}  // namespace glider::driver
