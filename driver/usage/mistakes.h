// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace glider::driver {

/// Reports an unknown command by its name, with the nearest and all that there are; returns
/// kWorldFailed.
int tellUnknownCommand(const CLI::App& app, const std::string& word);

/// Reports what is wrong with the command line `argv` that `app` refused with `error`; returns
/// kWorldFailed. Without any argument it shows the help on standard error.
int tellMistake(const CLI::App& app, int argc, char** argv, const CLI::ParseError& error);

}  // namespace glider::driver
