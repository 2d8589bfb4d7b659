// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/budget.h"
#include "codegen/input.h"
#include "codegen/options.h"
#include "platforms/load/board.h"
#include "support/result.h"

namespace glider::codegen {

/// Backend::measure: links the mission's executable and measures it. README.md says how. Fails as
/// writeExecutable does, except that a file that is too large is not an error.
support::Result<Budget> measureExecutable(const Input& input, const platforms::Board& board,
                                          const CodegenOptions& options);

/// The same of an executable that is already linked, with what it needs to be debugged.
support::Result<Budget> measureLinked(const std::string& linked, const Input& input,
                                      const platforms::Board& board);

}  // namespace glider::codegen
