// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "driver/usage/values.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

// Scripts with which shells complete the command line, from what CLI11 knows of it.

namespace glider::driver {

/// An option or a positional argument, as shells complete it.
struct Completed {
  std::vector<std::string> names;  ///< --format, -o; empty: a positional argument
  std::string description;
  std::string word;  ///< of the value, as in --help; empty: a flag
  ValueKind value;
  bool repeated = false;
};

/// A command with what it takes.
struct CompletedCommand {
  std::string name, description;
  std::vector<Completed> options, arguments;
};

/// All commands of `app` without what --help hides.
std::vector<CompletedCommand> completedCommands(const CLI::App& app);

/// The scripts, for bash 4, zsh 5 and fish 3 or later.
std::string bashCompletion(const std::vector<CompletedCommand>& commands);
std::string zshCompletion(const std::vector<CompletedCommand>& commands);
std::string fishCompletion(const std::vector<CompletedCommand>& commands);

/// Adds `completion SHELL`, which prints a script.
void addCompletionCommand(CLI::App& app, int& status);

}  // namespace glider::driver
