// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/result.h"

#include <llvm/IR/Module.h>

#include <filesystem>
#include <string>
#include <vector>

namespace glider::codegen {

/// Adds to the mission what it and the symbols `visible` need of the bitcode files `parts` of the
/// runtime, users before what they use, and makes all but those symbols internal, so that all is
/// optimised as one program. GL9001 if a file cannot be read, GL9050 if it is not right, or if
/// together they do not define all of `visible`.
support::Result<void> joinRuntime(llvm::Module& mission,
                                  const std::vector<std::filesystem::path>& parts,
                                  const std::vector<std::string>& visible);

/// Lets the mission be optimised with what it needs of the bitcode file `part`: the functions stand
/// in the module to be inlined and reasoned about, but their code is that of the runtime's object,
/// which the program is linked with (LLVM's available_externally). Errors as above.
support::Result<void> importRuntime(llvm::Module& mission, const std::filesystem::path& part);

/// clang writes the machine down on every function. It is the mission's machine: said once, by the
/// TargetMachine, it need not be parsed for each function and keeps none from being inlined.
void forgetMachine(llvm::Module& module);

}  // namespace glider::codegen
