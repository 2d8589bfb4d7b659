// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <llvm/IR/Module.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/result.h"

namespace glider::codegen {

/// Adds to the mission what it and `entry_points` need of the bitcode file `runtime`, and makes everything but the
/// entry points internal, so that mission and runtime are optimised as one program. `kept` are symbols of the mission
/// that stay visible. GL9001 if the runtime cannot be read, GL9050 if it is not right.
support::Result<void> joinRuntime(llvm::Module& mission, const std::filesystem::path& runtime,
                                  const std::vector<std::string>& entry_points,
                                  const std::vector<std::string>& kept);

}  // namespace glider::codegen
