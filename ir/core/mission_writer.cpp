// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/mission_writer.h"

#include "ir/core/ops.h"
#include "support/check.h"

#include <algorithm>

namespace glider::ir {

namespace {

template <typename Id, typename T>
Id addTo(std::vector<T>& list, T element) {
  list.push_back(std::move(element));
  return {static_cast<uint32_t>(list.size() - 1)};
}

}  // namespace

ExprId MissionWriter::add(const Expr& expr) {
  return addTo<ExprId>(m_.exprs, expr);
}

VariableId MissionWriter::add(Variable variable) {
  return addTo<VariableId>(m_.variables, std::move(variable));
}

BlockId MissionWriter::add(Block block) {
  return addTo<BlockId>(m_.blocks, std::move(block));
}

ExprId MissionWriter::truth(bool value) {
  return operation(value ? Op::True : Op::False, boolean(), {});
}

ExprId MissionWriter::number(double value, const Type& type) {
  Expr expr;
  expr.op = Op::Constant;
  expr.type = type;
  expr.number = value;
  expr.range = range_;
  return add(expr);
}

ExprId MissionWriter::now() {
  return operation(Op::MissionTime, quantity(support::dimension::time), {});
}

ExprId MissionWriter::read(VariableId variable) {
  Expr expr;
  expr.op = Op::Variable;
  expr.variable = variable;
  return typed(expr);
}

ExprId MissionWriter::read(SensorId sensor) {
  Expr expr;
  expr.op = Op::Sensor;
  expr.sensor = sensor;
  return typed(expr);
}

ExprId MissionWriter::read(TemporalId temporal) {
  Expr expr;
  expr.op = Op::Temporal;
  expr.temporal = temporal;
  return typed(expr);
}

ExprId MissionWriter::age(SensorId sensor) {
  Expr expr;
  expr.op = Op::Age;
  expr.sensor = sensor;
  return typed(expr);
}

ExprId MissionWriter::element(TableId table, ExprId number) {
  Expr expr;
  expr.op = Op::Element;
  expr.table = table;
  expr.operands[0] = number;
  return typed(expr);
}

ExprId MissionWriter::call(UseId use, std::span<const ExprId> arguments) {
  Expr expr;
  expr.op = Op::Call;
  expr.use = use;
  std::ranges::copy(arguments, expr.operands.begin());
  return typed(expr);
}

ExprId MissionWriter::negation(ExprId a) {
  return operation(Op::Not, boolean(), {a});
}

ExprId MissionWriter::both(ExprId a, ExprId b) {
  return operation(Op::And, boolean(), {a, b});
}

ExprId MissionWriter::either(ExprId a, ExprId b) {
  return operation(Op::Or, boolean(), {a, b});
}

ExprId MissionWriter::operation(Op op, const Type& type, std::initializer_list<ExprId> operands) {
  Expr expr;
  expr.op = op;
  expr.type = type;
  std::ranges::copy(operands, expr.operands.begin());
  expr.range = range_;
  return add(expr);
}

ExprId MissionWriter::operation(Op op, std::span<const ExprId> operands) {
  Expr expr;
  expr.op = op;
  std::ranges::copy(operands, expr.operands.begin());
  return typed(expr);
}

ExprId MissionWriter::typed(Expr expr) {
  expr.range = range_;
  const auto type = resultType(m_, expr);
  CHECK(type, "operands that an operation does not take");
  expr.type = *type;
  return add(expr);
}

VariableId MissionWriter::variable(const std::string& name, VariableKind kind, const Type& type,
                                   ExprId initial) {
  Variable variable;
  variable.name = prefix_.empty() ? name : prefix_ + "." + name;
  variable.type = type;
  variable.kind = kind;
  variable.initial = initial;
  variable.range = range_;
  return add(std::move(variable));
}

VariableId MissionWriter::flag(const std::string& name, VariableKind kind) {
  return variable(name, kind, boolean(), truth(false));
}

Statement MissionWriter::assignment(VariableId variable, ExprId value) const {
  Statement statement;
  statement.kind = StatementKind::Set;
  statement.variable = variable;
  statement.value = value;
  statement.range = range_;
  return statement;
}

Statement MissionWriter::branch(ExprId condition, BlockId then) const {
  Statement statement;
  statement.kind = StatementKind::If;
  statement.value = condition;
  statement.then = then;
  statement.range = range_;
  return statement;
}

}  // namespace glider::ir
