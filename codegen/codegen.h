// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/input.h"
#include "platforms/load/board.h"
#include "support/result.h"
#include "support/source_manager.h"

#include <filesystem>
#include <string>
#include <vector>

/// From a mission without errors to machine code for a board.
namespace glider::codegen {

struct CodegenOptions {
  /// 0 to 3. At 3 mission and runtime are optimised as one program; below, the mission is compiled
  /// alone and linked with the runtime's object, made of the same bitcode: a twentieth of the time.
  int optimisation_level = 2;
  /// Line tables for `sources`, which holds the files of the mission's ranges; null: none.
  bool debug = true;
  const support::SourceManager* sources = nullptr;
  /// Objects and archives for the board that define the mission's extern behaviours.
  std::vector<std::filesystem::path> further_inputs;
  /// This process links nothing after this; linking is a little faster then.
  bool last_link = false;
};

/// The mission alone (no runtime), optimised: LLVM's text, assembly, a relocatable ELF object.
/// GL4002, GL4006, GL4007.
support::Result<std::string> emitLlvm(const Input& input, const platforms::Board& board,
                                      const CodegenOptions& options);
support::Result<std::string> emitAssembly(const Input& input, const platforms::Board& board,
                                          const CodegenOptions& options);
support::Result<std::string> emitObject(const Input& input, const platforms::Board& board,
                                        const CodegenOptions& options);

/// Writes the board's executable to `output`, stripped, and with options.debug its line tables to
/// `output`.debug; both whole or not at all. GL4002 to GL4007, GL9001, GL9002, GL9050.
support::Result<void> linkExecutable(const Input& input, const platforms::Board& board,
                                     const CodegenOptions& options,
                                     const std::filesystem::path& output);

/// The content of the board's executable, stripped, for a pipe or device. Errors as linkExecutable.
support::Result<std::string> linkForStream(const Input& input, const platforms::Board& board,
                                           const CodegenOptions& options);

/// The content of a shared object for this machine that exports `gliderMission` and
/// runtime/abi/entry_points.def: what load/loaded_mission.h loads. `host` must be the host's board.
/// Errors as linkExecutable.
support::Result<std::string> linkShared(const Input& input, const platforms::Board& host,
                                        const CodegenOptions& options);

}  // namespace glider::codegen
