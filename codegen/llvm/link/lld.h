// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/target/machine.h"
#include "platforms/load/board.h"
#include "support/result.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace glider::codegen {

/// What to link into one file.
struct LinkJob {
  ProgramKind kind = ProgramKind::Executable;
  std::vector<std::string> objects;                   ///< contents of the mission's objects
  std::vector<std::filesystem::path> further_inputs;  ///< other objects and archives
  std::vector<std::string> exports;                   ///< of a shared object
  bool keep_debug = false;  ///< if false, symbols and line tables are left out
  bool last = false;  ///< this process links nothing after it: no child is needed, which saves 3 ms
};

/// Links with the lld that is part of this program and writes nothing to the terminal; returns the
/// content of the linked file. GL4003 for an undefined symbol, GL4004 for any other error of lld,
/// GL9002 if there is no room for temporary files.
support::Result<std::string> link(const LinkJob& job, const platforms::Board& board);

}  // namespace glider::codegen
