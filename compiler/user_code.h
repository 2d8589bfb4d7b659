// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/user_code.h"
#include "ir/core/mission.h"
#include "platforms/load/board.h"
#include "support/result.h"

#include <string>
#include <vector>

namespace glider::compiler {

/// What `files` hold, checked for the mission and the board. Errors as codegen::UserCode::load.
support::Result<codegen::UserCode> loadUserCode(const std::vector<std::string>& files,
                                                const ir::Mission& mission,
                                                const platforms::Board& board);

}  // namespace glider::compiler
