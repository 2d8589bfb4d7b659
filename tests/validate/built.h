// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/input.h"
#include "codegen/validation.h"

#include <llvm/IR/LLVMContext.h>
#include <llvm/IR/Module.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace glider::validate_test {

/// What changes a module; empty: nothing does.
using Change = std::function<void(llvm::Module&)>;

/// Compiles the mission for `board` at `level` as a build does, changes the code that lowering made
/// and that the passes made of it, and compares the result with the mission.
codegen::Validation validate(const codegen::Input& input, const std::string& board, int level,
                             const Change& lowered = {}, const Change& optimised = {});

/// The same code as text.
std::string codeOf(const codegen::Input& input, const std::string& board, int level,
                   const Change& lowered = {});

/// The parts that are not `Same`, a line each; empty: all are.
std::string whatIsNotSame(const codegen::Validation& validation);

/// A whole number from the environment.
uint64_t setting(const char* name, uint64_t otherwise);

}  // namespace glider::validate_test
