// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <llvm/IR/Module.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/result.h"

namespace glider::codegen {

/// Adds to the mission what it and the symbols `visible` need of the bitcode file `runtime`, and makes all but those
/// symbols internal, so that mission and runtime are optimised as one program. GL9001 if the file cannot be read, GL9050
/// if it is not right, or if the two do not define all of `visible`.
support::Result<void> joinRuntime(llvm::Module& mission, const std::filesystem::path& runtime,
                                  const std::vector<std::string>& visible);

}  // namespace glider::codegen
