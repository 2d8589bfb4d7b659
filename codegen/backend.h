// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/budget.h"
#include "codegen/input.h"
#include "codegen/options.h"
#include "platforms/load/board.h"
#include "support/result.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

/// The interface of a back end: constants that say what it makes from a mission, for which boards,
/// and with which functions. backends.def lists the back ends; codegen.h chooses among them.
namespace glider::codegen {

/// Returns the content of a file made from the mission. Anything missing in the board or the
/// mission is a Failure that the pilot can read; nothing is written.
using Make = support::Result<std::string>(const Input& input, const platforms::Board& board,
                                          const CodegenOptions& options);

/// Writes the mission's file `output` and the files beside it: all of them complete, or none.
using Write = support::Result<void>(const Input& input, const platforms::Board& board,
                                    const CodegenOptions& options,
                                    const std::filesystem::path& output);

/// What the mission needs of a board, measured on what would be written.
using Measure = support::Result<Budget>(const Input& input, const platforms::Board& board,
                                        const CodegenOptions& options);

/// A value of `--emit`. Several back ends may have the same one, for different boards.
struct Product {
  std::string_view name;       ///< the value
  std::string_view suffix;     ///< of the file, if none is named
  std::string_view note = {};  ///< what --help adds to the value; empty: nothing
  /// Whether the product is machine code or similar: it depends on the board, contains the code of
  /// `--link`, and its file is named after both. If not, it is the same for all boards.
  bool for_board = false;
  Make* make = nullptr;
  Write* write = nullptr;        ///< null: the file contains the result of `make`
  std::string_view beside = {};  ///< suffix of a second file that `write` makes; empty: none
};

struct Backend {
  bool (*serves)(const platforms::Board& board) = nullptr;  ///< whether it can make code for it
  std::span<const Product> products = {};
  // The functions for a program that flies, is loaded or is measured; null: this back end has none.
  Write* link_executable = nullptr;  ///< what the board runs, or its emulator
  Make* link_shared = nullptr;       ///< what load/loaded_mission.h loads
  Measure* measure = nullptr;
};

#define BACKEND(name) extern const Backend name;
#include "codegen/backends.def"
#undef BACKEND

}  // namespace glider::codegen
