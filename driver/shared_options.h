// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "flights/launch_choice.h"
#include "report/picture/picture.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

// Options that several commands have.

namespace glider::driver {

/// Adds --set and --parameters to `command`.
void addLaunchOptions(CLI::App& command, flights::LaunchChoice& choice);

/// Adds --effort and --timeout, the limits of proofs, to `command`.
void addProofOptions(CLI::App& command, unsigned& effort, std::optional<double>& timeout_s);

/// Adds --link FILE to `command`.
void addLinkOption(CLI::App& command, std::vector<std::string>& files);

/// The values of --colour-by: what can colour the track of a picture.
std::vector<std::string> trackColours();
/// Adds --picture FILE and --colour-by to `command`; returns the first.
CLI::Option* addPictureOptions(CLI::App& command, std::string& file, report::PictureStyle& style);
/// Adds --colour-by, which needs the option `picture`. Its old name --colour, too easily taken for
/// --color, goes on to work; --help does not show it.
void addColourOption(CLI::App& command, report::PictureStyle& style, CLI::Option* picture,
                     const std::string& description);

/// `--no-cache`, which does nothing: every check searches its proofs itself. Scripts of earlier
/// versions, which kept proofs, go on to work; --help does not show it.
void acceptNoCache(CLI::App& command);

/// For --seed: an unsigned whole number of 64 bits; CLI11 alone would wrap `-1` around.
CLI::Validator seedValidator();

}  // namespace glider::driver
