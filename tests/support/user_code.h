// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>
#include <string>

namespace glider::tests {

/// Compiles C++ as a scientist does, with the header of `mission` beside it and clang's flags of
/// `board`, then `flags`. The object is `name`, in the folder of `source`; its path.
std::string compileFor(const std::string& board, const std::filesystem::path& mission,
                       const std::filesystem::path& source, const std::string& name,
                       const std::string& flags = "");

}  // namespace glider::tests
