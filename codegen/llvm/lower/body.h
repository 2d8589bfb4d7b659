// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/lower/expressions.h"
#include "codegen/llvm/lower/lowering.h"

#include <llvm/ADT/STLFunctionalExtras.h>

#include <map>
#include <set>
#include <vector>

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

/// A function as a Body has, which stands in another part of the mission.
llvm::Function* declareFunction(Lowering& lowering, const std::string& name, Body::Result result,
                                unsigned more);
/// Lets the other parts call it.
void showToParts(llvm::Function& function);

/// Runs the statements of a block where `body` stands; an invalid id is an empty block. What was
/// made before stays made.
void lowerBlock(Body& body, ir::BlockId block);
/// Gives a variable a value.
void assign(Body& body, ir::VariableId variable, llvm::Value* value);

/// Start: their list becomes current by goto, call or return, or the mission begins.
enum class Moment : uint8_t { Start, Advance };
/// Starts or advances temporals, in their order. Windows advance in either case: they outlive a
/// call, and lowerWindowStarts empties them.
void lowerTemporals(Body& body, const std::vector<ir::TemporalId>& temporals, Moment moment);
/// Empties those that are windows: their list becomes current by goto or call, or the mission
/// begins.
void lowerWindowStarts(Body& body, const std::vector<ir::TemporalId>& temporals);
/// Whether windows that read the same sensors may take a reading now, as u32.
using Freshness = std::map<std::set<uint32_t>, llvm::Value*>;
/// Advances a window. `fresh` holds what has been made in the builder's block.
void lowerWindow(Body& body, ir::TemporalId id, Freshness& fresh);

/// Calls an activity's C function (runtime/abi/behaviour.h) with its arguments, evaluated here.
void callBehaviour(Body& body, const ir::Activity& activity, uint32_t memory_block,
                   llvm::Value* phase);

}  // namespace glider::codegen
