// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/input.h"
#include "codegen/llvm/lower/lower_mission.h"
#include "codegen/validation.h"
#include "support/result.h"

#include <llvm/IR/Module.h>

#include <filesystem>

/// Translation validation: each build is compared with the mission that it was built from, without
/// trust in the code generator or in LLVM's passes. `validate/README.md` says how, and what is
/// trusted instead.
namespace glider::codegen {

/// Compares the optimised `module` of a part of the mission with the mission. `inlinable` is the
/// bitcode of the runtime's functions that may have been inlined. GL9001, GL9050 if that cannot be
/// read.
support::Result<Validation> validatePart(const Input& input, const MissionPart& part,
                                         const llvm::Module& module,
                                         const std::filesystem::path& inlinable);

}  // namespace glider::codegen
