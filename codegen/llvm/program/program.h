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
/// runtime, users before what they use, and of `whole` everything: files that use what also uses
/// them. Makes all symbols but `visible` internal, so that everything is optimised as one program.
/// GL9001 if a file cannot be read, GL9050 if it is not valid, or if together the files do not
/// define all of `visible`.
support::Result<void> joinRuntime(llvm::Module& mission,
                                  const std::vector<std::filesystem::path>& parts,
                                  const std::vector<std::string>& visible,
                                  const std::vector<std::filesystem::path>& whole = {});

/// Lets the mission be optimised with what it needs of the bitcode file `part`. The functions are
/// in the module to be inlined and analysed, but their code is that of the runtime's object, which
/// the program is linked with (LLVM's available_externally). Errors as above.
support::Result<void> importRuntime(llvm::Module& mission, const std::filesystem::path& part);

/// Removes the machine that clang records on every function. It is the mission's machine: the
/// TargetMachine states it once, so it need not be parsed for each function and does not prevent
/// inlining.
void forgetMachine(llvm::Module& module);

}  // namespace glider::codegen
