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
/// Its first parameter is the GliderContext; all others are u32, except for a last pointer if it
/// has a `place`.
struct Body {
  enum class Result : uint8_t { None, Word };
  /// `more` parameters after the context. A debugger shows it as `title` at `range`; without a
  /// title it has no line table.
  Body(Lowering& shared, const std::string& name, Result result, unsigned more,
       const std::string& title = "", support::SourceRange range = {}, bool place = false);

  [[nodiscard]] llvm::Value* context() const { return function->getArg(0); }
  /// A new basic block at the end.
  llvm::BasicBlock* block(const char* name);
  llvm::Value* contextField(unsigned index);
  /// Calls a C function that returns nothing: of the runtime, or of a profile or route.
  void call(llvm::StringRef symbol, llvm::ArrayRef<llvm::Value*> arguments);

  Lowering& lowering;
  llvm::Function* function;
  llvm::IRBuilder<> builder;
  Expressions expressions;
};

/// Declares a function with the type of a Body that another part of the mission defines.
llvm::Function* declareFunction(Lowering& lowering, const std::string& name, Body::Result result,
                                unsigned more, bool place = false);
/// Makes it visible to the other parts.
void showToParts(llvm::Function& function);

/// Generates the statements of a block at the place of `body`; an invalid id is an empty block.
/// Expressions generated before remain usable.
void lowerBlock(Body& body, ir::BlockId block);
/// Generates an assignment to a variable.
void assign(Body& body, ir::VariableId variable, llvm::Value* value);

/// Start: their list becomes current by goto, call or return, or the mission begins.
enum class TemporalMoment : uint8_t { Start, Advance };
/// Starts or advances temporals, in their order. Windows advance in both cases: they keep their
/// content during a call, and lowerWindowStarts empties them.
void lowerTemporals(Body& body, const std::vector<ir::TemporalId>& temporals,
                    TemporalMoment moment);
/// Empties those that are windows: their list becomes current by goto or call, or the mission
/// begins.
void lowerWindowStarts(Body& body, const std::vector<ir::TemporalId>& temporals);
/// Whether windows that read the same sensors may take a reading now, as u32.
using Freshness = std::map<std::set<uint32_t>, llvm::Value*>;
/// Advances a window. `fresh` holds the values already generated in the builder's block.
void lowerWindow(Body& body, ir::TemporalId id, Freshness& fresh);
/// The same for a window over a leg.
void lowerLeg(Body& body, ir::TemporalId id, Freshness& fresh);

/// Generates the command of how often instruments read (gliderSample).
void lowerSampling(Body& body, const ir::State& state);

/// Calls an activity's C function (runtime/abi/behaviour.h) with its arguments, evaluated here.
void callBehaviour(Body& body, const ir::Activity& activity, uint32_t memory_block,
                   llvm::Value* phase);

}  // namespace glider::codegen
