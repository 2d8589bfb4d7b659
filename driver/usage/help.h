// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace glider::driver {

/// --help, and the words of the manual page: lists the choices that a description does not name,
/// and ends with examples.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option_desc(const CLI::Option* option) const override;
  std::string make_footer(const CLI::App* app) const override;
};

/// The help of `command`, which is `app` or one of its commands.
std::string helpOf(const CLI::App& command);

/// Adds `help COMMAND`, the same as `COMMAND --help`.
void addHelpCommand(CLI::App& app, int& status);

}  // namespace glider::driver
