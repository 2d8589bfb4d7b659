// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/validate/memory.h"

#include <llvm/ADT/DenseMap.h>
#include <llvm/IR/Instructions.h>
#include <llvm/IR/Module.h>

#include <map>
#include <string>
#include <vector>

namespace glider::codegen::validate {

/// The place of a constant by what it holds: equal constants are one.
Address constantPlace(Places& places, const llvm::Constant& content);

/// What functions of a module do, from LLVM's definition of its instructions. Only what missions
/// are made of is understood; all else throws Undecided. That an operation does not overflow where
/// the module promises it is taken for granted.
class Code {
 public:
  /// `inlinable` has the bodies of the runtime's functions that may have been inlined: a call of
  /// one does what its body does. All outlive this.
  Code(Effects& effects, const llvm::Module& inlinable)
      : effects_(effects), inlinable_(inlinable) {}

  /// Called with these arguments, pointers as addresses.
  Outcome run(const llvm::Function& function, const std::vector<z3::expr>& arguments,
              const Memory& before);
  /// What a call of that function of the runtime does, which returns nothing.
  void command(Memory& memory, const std::string& name, const std::vector<z3::expr>& arguments);

  Effects& effects() { return effects_; }

 private:
  Effects& effects_;
  const llvm::Module& inlinable_;
  uint32_t frames_ = 0;  ///< numbers of local objects
  uint32_t depth_ = 0;   ///< of calls
  uint32_t unknowns_ = 0;

  friend class Run;
};

}  // namespace glider::codegen::validate
