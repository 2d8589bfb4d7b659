// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "compiler/user_code.h"

namespace glider::compiler {

support::Result<codegen::UserCode> loadUserCode(const std::vector<std::string>& files,
                                                const ir::Mission& mission,
                                                const platforms::Board& board) {
  return codegen::UserCode::load({files.begin(), files.end()}, mission, board);
}

}  // namespace glider::compiler
