// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/backend.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// Makes products from a mission without errors with the back ends: machine code for a board, a
/// text.
namespace glider::codegen {

/// The products of all back ends, each name once, in the order of backends.def.
std::vector<const Product*> products();

/// The product called `name` for `board`; null: no back end makes it for that board.
const Product* findProduct(std::string_view name, const platforms::Board& board);

/// Makes `product` and writes it to the file `output`, complete or not at all. Fails as its back
/// end does; GL9002.
support::Result<void> writeProduct(const Product& product, const Input& input,
                                   const platforms::Board& board, const CodegenOptions& options,
                                   const std::filesystem::path& output);

// The first back end that can do this for the board is used. GL4002 if none can, otherwise its
// errors: llvm/llvm.h lists those for machine code.

/// Writes the board's executable to `output`, stripped, and with options.debug its line tables to
/// `output`.debug; both complete or not at all.
support::Result<void> linkExecutable(const Input& input, const platforms::Board& board,
                                     const CodegenOptions& options,
                                     const std::filesystem::path& output);

/// The content of a shared object for this machine that exports `gliderMission` and
/// runtime/abi/entry_points.def: load/loaded_mission.h loads it. `host` must be the host's board.
support::Result<std::string> linkShared(const Input& input, const platforms::Board& host,
                                        const CodegenOptions& options);

/// Builds the mission for `board` as `glidercc build` does and measures the result. `mission` is
/// compiled as it is, so it must already be optimised if it should be. A file that is too large is
/// not an error.
support::Result<Budget> measureBudget(const Input& input, const platforms::Board& board,
                                      const CodegenOptions& options);

}  // namespace glider::codegen
