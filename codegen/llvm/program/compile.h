// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/input.h"
#include "codegen/llvm/lower/lower_mission.h"
#include "codegen/llvm/target/machine.h"
#include "codegen/options.h"

#include <llvm/IR/LLVMContext.h>
#include <llvm/IR/Module.h>
#include <llvm/Target/TargetMachine.h>

#include <memory>
#include <string>
#include <vector>

namespace glider::codegen {

/// A module, and before it the objects that it depends on.
struct Unit {
  std::unique_ptr<llvm::LLVMContext> context;
  std::unique_ptr<llvm::TargetMachine> machine;
  std::unique_ptr<llvm::Module> module;
};

/// The mission alone, lowered and not optimised. GL4002, GL4006, GL4007.
support::Result<Unit> lowerWhole(const Input& input, const platforms::Board& board,
                                 const CodegenOptions& options, ProgramKind kind);

/// What a program is linked from, in addition to the board's own inputs.
struct Program {
  std::vector<std::string> objects;
  std::vector<std::filesystem::path> further_inputs;
  Validation validation;  ///< of the objects; empty unless it is asked for
};

/// Compiles the mission together with the runtime, as the optimisation level says; `visible` lists
/// the program's exports. Uses as many threads as the mission has parts.
support::Result<Program> compileProgram(const Input& input, const platforms::Board& board,
                                        const CodegenOptions& options, ProgramKind kind,
                                        const std::vector<std::string>& visible);

}  // namespace glider::codegen
