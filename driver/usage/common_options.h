// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace CLI {
class App;
}

namespace glider::driver {

/// Adds the options that every command has: --color and --quiet. They act on the terminal
/// (driver/terminal.h).
void addCommonOptions(CLI::App& command);

}  // namespace glider::driver
