// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/input.h"
#include "codegen/options.h"
#include "platforms/load/board.h"
#include "support/result.h"

#include <filesystem>
#include <string>

/// The back end that generates machine code, with LLVM and lld.
namespace glider::codegen {

/// The mission alone (no runtime), optimised: LLVM's text, assembly, a relocatable ELF object.
/// GL4002, GL4006, GL4007; GL5001 if the platform lacks a sensor that the hooks need.
support::Result<std::string> emitLlvm(const Input& input, const platforms::Board& board,
                                      const CodegenOptions& options);
support::Result<std::string> emitAssembly(const Input& input, const platforms::Board& board,
                                          const CodegenOptions& options);
support::Result<std::string> emitObject(const Input& input, const platforms::Board& board,
                                        const CodegenOptions& options);

/// Backend::link_executable. GL4002 to GL4007, GL5001, GL9001, GL9002, GL9050.
support::Result<void> writeExecutable(const Input& input, const platforms::Board& board,
                                      const CodegenOptions& options,
                                      const std::filesystem::path& output);

/// The content of the board's executable, stripped, for a pipe or device. Fails as writeExecutable
/// does.
support::Result<std::string> makeExecutable(const Input& input, const platforms::Board& board,
                                            const CodegenOptions& options);

/// Backend::link_shared. Fails as writeExecutable does.
support::Result<std::string> makeShared(const Input& input, const platforms::Board& host,
                                        const CodegenOptions& options);

}  // namespace glider::codegen
