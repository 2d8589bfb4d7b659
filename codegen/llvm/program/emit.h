// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <llvm/IR/Module.h>
#include <llvm/Support/CodeGen.h>
#include <llvm/Target/TargetMachine.h>

#include <string>

namespace glider::codegen {

/// The module as text in LLVM's own language.
std::string printModule(const llvm::Module& module);
/// Assembly text or an ELF object, made by the machine's code generator. Changes the module.
std::string emitCode(llvm::Module& module, llvm::TargetMachine& machine,
                     llvm::CodeGenFileType type);

}  // namespace glider::codegen
