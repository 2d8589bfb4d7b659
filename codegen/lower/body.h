// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/lower/expressions.h"
#include "codegen/lower/lowering.h"

namespace glider::codegen {

/// A function of the generated module while it is written: internal, does not unwind, strict IEEE.
/// Its first parameter is the GliderContext, all others are u32.
struct Body {
  enum class Result : uint8_t { None, Word };
  /// `more` parameters after the context. A debugger shows it as `title` at `range`; no title, no
  /// line table.
  Body(Lowering& shared, const std::string& name, Result result, unsigned more,
       const std::string& title = "", support::SourceRange range = {});

  [[nodiscard]] llvm::Value* context() const { return function->getArg(0); }
  /// A new basic block at the end.
  llvm::BasicBlock* block(const char* name);
  llvm::Value* contextField(unsigned index);

  Lowering& lowering;
  llvm::Function* function;
  llvm::IRBuilder<> builder;
  Expressions expressions;
};

/// Runs the statements of a block where `body` stands; an invalid id is an empty block. What was
/// made before stays made.
void lowerBlock(Body& body, ir::BlockId block);
/// Gives a variable a value.
void assign(Body& body, ir::VariableId variable, llvm::Value* value);

/// Start: their list becomes current by goto or call, or the mission begins. Resume: by return.
enum class Moment : uint8_t { Start, Resume, Advance };
/// Starts, resumes or advances temporals, in their order.
void lowerTemporals(Body& body, const std::vector<ir::TemporalId>& temporals, Moment moment);
/// The same for one that is a window.
void lowerWindow(Body& body, ir::TemporalId id, Moment moment);

/// Calls an activity's C function (runtime/abi/behaviour.h) with its arguments, evaluated here.
void callBehaviour(Body& body, const ir::Activity& activity, uint32_t memory_block,
                   llvm::Value* phase);

}  // namespace glider::codegen
