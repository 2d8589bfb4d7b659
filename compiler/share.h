// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>

namespace glider::compiler {

/// The folder of the command's data (platforms, library, boards, scenarios): share/glidercc beside
/// the bin/ that holds the running program, so that it is found both in a build tree and in an
/// installation. GLIDERCC_SHARE overrides it.
std::filesystem::path shareDirectory();

}  // namespace glider::compiler
