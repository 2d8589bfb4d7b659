// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>

namespace CLI {
class App;
class Formatter;
}  // namespace CLI

namespace glider::driver {

/// The manual page glidercc(1) in roff's man macros: every command with every option of `app`, in
/// `words`, those of its --help, so that the two cannot differ.
std::string manPage(const CLI::App& app, const CLI::Formatter& words);

}  // namespace glider::driver
