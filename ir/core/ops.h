// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <optional>
#include <string_view>
#include <vector>

namespace glider::ir {

/// A row of ops.def.
struct OpInfo {
  Op op;
  std::string_view text;  ///< spelling in the text form
  uint32_t operands;      ///< of a Call none: see operandCount
};

/// The row of `op`.
const OpInfo& opInfo(Op op);
/// The row spelled `text`; null if there is none.
const OpInfo* findOp(std::string_view text);
/// The number of operations.
size_t opCount();
/// The number of operands of `expr`: those of its operation, or as many as a Call has.
uint32_t operandCount(const Expr& expr);

/// Whether it compares: Less to NotEqual.
bool isComparison(Op op);
/// Whether it is a comparison that asks for the order of numbers: Less to GreaterEqual.
bool isOrdering(Op op);
/// The comparison that is true exactly where `comparison` (Less to NotEqual) is false.
Op negated(Op comparison);

/// Whether it is a window: a number, not a truth value.
bool isWindow(TemporalKind kind);

/// A row of commands.def.
struct CommandInfo {
  Command command;
  std::string_view text;    ///< spelling, in the language and in the text form
  std::string_view symbol;  ///< C function of runtime/abi/behaviour.h
  std::vector<Parameter> parameters;
};

/// The rows of commands.def, in the order of Command.
const std::vector<CommandInfo>& commands();

/// The type that `expr` must have in `mission`, given its operands' types (or its sensor's or
/// variable's): sums, minima and the like want one type, products and quotients multiply
/// dimensions, comparisons compare like with like. A Constant keeps its own. Empty if the operands
/// do not fit. Operands, sensor, variable, temporal, table and use must be in range, and what a
/// temporal watches must stand before `expr`.
std::optional<Type> resultType(const Mission& mission, const Expr& expr);

}  // namespace glider::ir
