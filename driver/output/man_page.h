// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>

namespace CLI {
class App;
}

namespace glider::driver {

/// The manual page glidercc(1) in roff's man macros: every command with every option of `app`, in
/// the words of its --help, so that the two cannot differ.
std::string manPage(const CLI::App& app);

}  // namespace glider::driver
