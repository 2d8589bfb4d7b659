// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/scratch_folder.h"
#include "platforms/load/board.h"
#include "support/result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace glider::codegen {

/// A file to be linked that the user has given.
struct UserFile {
  std::string name;                  ///< as it was given
  std::string content;               ///< an object or archive for the board
  std::vector<std::string> defines;  ///< the symbols that others may use
};

/// Reads and checks an object or archive, and compiles bitcode, with `scratch` for temporary files.
/// Fails as UserCode::load does, except for GL4011.
support::Result<UserFile> readUserFile(const std::filesystem::path& path,
                                       const platforms::Board& board, const ScratchFolder& scratch);

}  // namespace glider::codegen
