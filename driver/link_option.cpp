// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/link_option.h"

#include <CLI/CLI.hpp>

namespace glider::driver {

void addLinkOption(CLI::App& command, std::vector<std::string>& files) {
  command
      .add_option("--link", files,
                  "Link an object file, archive or LLVM bitcode that defines the mission's "
                  "`extern` declarations; may be repeated")
      ->option_text("FILE")
      ->take_all()
      ->allow_extra_args(false);
}

support::Result<codegen::UserCode> loadUserCode(const std::vector<std::string>& files,
                                                const Compilation& compilation,
                                                const platforms::Board& board) {
  return codegen::UserCode::load({files.begin(), files.end()}, *compilation.mission, board);
}

}  // namespace glider::driver
