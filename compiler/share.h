// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>

namespace glider::compiler {

/// Where the command's data lie (platforms, library, boards, scenarios): share/glidercc beside the
/// bin/ that holds the running program, so that a build tree and an installation are found alike.
/// GLIDERCC_SHARE overrides.
std::filesystem::path shareDirectory();

}  // namespace glider::compiler
