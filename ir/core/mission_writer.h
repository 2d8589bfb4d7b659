// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/core/types.h"

#include <initializer_list>
#include <span>
#include <string>
#include <utility>

namespace glider::ir {

/// Writes expressions, variables and blocks to a mission. What is new comes last in its list, in
/// the order of the calls, so everything keeps its number. Outside tests, nothing else adds to
/// these lists.
class MissionWriter {
 public:
  /// What is written has this range, and the names of its variables begin with `prefix` and a
  /// point, unless that is empty. `mission` outlives this.
  explicit MissionWriter(Mission& mission, const support::SourceRange& range = {},
                         std::string prefix = {})
      : m_(mission), range_(range), prefix_(std::move(prefix)) {}

  // As they are, with ranges and names of their own.
  ExprId add(const Expr& expr);
  VariableId add(Variable variable);
  BlockId add(Block block);

  // Expressions.
  ExprId truth(bool value);
  ExprId number(double value, const Type& type);
  /// The mission time.
  ExprId now();
  /// Its value in this tick.
  ExprId read(VariableId variable);
  ExprId read(SensorId sensor);
  ExprId read(TemporalId temporal);
  /// Of the latest reading.
  ExprId age(SensorId sensor);
  ExprId element(TableId table, ExprId number);
  ExprId call(UseId use, std::span<const ExprId> arguments);
  ExprId negation(ExprId a);
  ExprId both(ExprId a, ExprId b);
  ExprId either(ExprId a, ExprId b);
  ExprId operation(Op op, const Type& type, std::initializer_list<ExprId> operands);
  /// Of the type that the operation's row gives; the operands must fit.
  ExprId operation(Op op, std::span<const ExprId> operands);

  // Variables.
  VariableId variable(const std::string& name, VariableKind kind, const Type& type, ExprId initial);
  /// A truth value, false at first.
  VariableId flag(const std::string& name, VariableKind kind);

  // Statements, for a block.
  [[nodiscard]] Statement assignment(VariableId variable, ExprId value) const;
  /// Runs `then` where `condition` is true.
  [[nodiscard]] Statement branch(ExprId condition, BlockId then) const;

 private:
  /// With its type by the operation's row.
  ExprId typed(Expr expr);

  Mission& m_;
  support::SourceRange range_;
  std::string prefix_;
};

}  // namespace glider::ir
