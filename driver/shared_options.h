// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "flights/launch_choice.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

// Options that several commands have.

namespace glider::driver {

/// Adds --set and --parameters to `command`.
void addLaunchOptions(CLI::App& command, flights::LaunchChoice& choice);

/// Adds --link FILE to `command`.
void addLinkOption(CLI::App& command, std::vector<std::string>& files);

/// For --seed: a whole number of 64 bits without a sign; CLI11 alone would wrap `-1` round.
CLI::Validator seedValidator();

}  // namespace glider::driver
