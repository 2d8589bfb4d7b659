// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/promises/monitor_builder.h"

#include "frontend/sema/names/types.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::frontend {

using ir::ExprId;
using ir::Op;

ExprId MonitorBuilder::push(ir::Expr expr) {
  expr.range = range_;
  m_.exprs.push_back(expr);
  return {static_cast<uint32_t>(m_.exprs.size() - 1)};
}

ir::VariableId MonitorBuilder::make(const std::string& name, ir::VariableKind kind,
                                    const ir::Type& type, ExprId initial) {
  ir::Variable variable;
  variable.name = fmt::format("{}.{}.{}", prefix_, m_.variables.size(), name);
  variable.type = type;
  variable.kind = kind;
  variable.initial = initial;
  variable.range = range_;
  m_.variables.push_back(std::move(variable));
  return {static_cast<uint32_t>(m_.variables.size() - 1)};
}

ir::VariableId MonitorBuilder::flag(const std::string& name, bool first) {
  const auto id = make(name, ir::VariableKind::Monitor, boolean(), truth(first));
  kept_.push_back({id, false});
  return id;
}

ir::VariableId MonitorBuilder::clock(const std::string& name) {
  const ir::Type time = quantity(support::dimension::time);
  const auto id = make(name, ir::VariableKind::Monitor, time, number(0, time));
  kept_.push_back({id, true});
  return id;
}

ir::VariableId MonitorBuilder::counter(const std::string& name, double most) {
  const auto id = make(name, ir::VariableKind::Monitor, plainNumber(), number(0, plainNumber()));
  m_.variables[id.index].lowest = 0;
  m_.variables[id.index].highest = most;
  kept_.push_back({id, false});
  return id;
}

ir::VariableId MonitorBuilder::value(const std::string& name, const ir::Type& type) {
  const auto id = make(name, ir::VariableKind::Monitor, type, number(0, type));
  kept_.push_back({id, false});
  return id;
}

ir::VariableId MonitorBuilder::momentary(const std::string& name) {
  const auto id = make(name, ir::VariableKind::Momentary, boolean(), {});
  set(id, false);
  return id;
}

ExprId MonitorBuilder::read(ir::VariableId variable) {
  ir::Expr expr;
  expr.op = Op::Variable;
  expr.type = m_[variable].type;
  expr.variable = variable;
  return push(expr);
}

ExprId MonitorBuilder::truth(bool value) {
  return operation(value ? Op::True : Op::False, boolean(), {});
}

ExprId MonitorBuilder::number(double value, const ir::Type& type) {
  ir::Expr expr;
  expr.op = Op::Constant;
  expr.type = type;
  expr.number = value;
  return push(expr);
}

ExprId MonitorBuilder::now() {
  return operation(Op::MissionTime, quantity(support::dimension::time), {});
}

ExprId MonitorBuilder::negation(ExprId a) {
  return operation(Op::Not, boolean(), {a});
}

ExprId MonitorBuilder::both(ExprId a, ExprId b) {
  return operation(Op::And, boolean(), {a, b});
}

ExprId MonitorBuilder::either(ExprId a, ExprId b) {
  return operation(Op::Or, boolean(), {a, b});
}

ExprId MonitorBuilder::operation(Op op, const ir::Type& type,
                                 std::initializer_list<ExprId> operands) {
  ir::Expr expr;
  expr.op = op;
  expr.type = type;
  std::ranges::copy(operands, expr.operands.begin());
  return push(expr);
}

ExprId MonitorBuilder::passed(ir::VariableId clock, double seconds) {
  const ir::Type time = quantity(support::dimension::time);
  const ExprId present = now();
  const ExprId since = read(clock);
  const ExprId gone = operation(Op::Subtract, time, {present, since});
  return operation(Op::Greater, boolean(), {gone, number(seconds, time)});
}

ExprId MonitorBuilder::observed(ir::ObservationKind kind, ir::StateId state) {
  const auto [found, made] = observations_.try_emplace({kind, state.index});
  if (made) {
    const char* what = kind == ir::ObservationKind::Entered  ? "entered"
                       : kind == ir::ObservationKind::Inside ? "inside"
                                                             : "ended";
    found->second = make(what, ir::VariableKind::Momentary, boolean(), {});
    monitor_.observations.push_back({found->second, kind, state});
  }
  return read(found->second);
}

ExprId MonitorBuilder::isTrue(ExprId a) {
  const ir::VariableId known = momentary("is");
  when(a, [&] { set(known, true); });
  return read(known);
}

void MonitorBuilder::set(ir::VariableId variable, ExprId value) {
  ir::Statement statement;
  statement.kind = ir::StatementKind::Set;
  statement.variable = variable;
  statement.value = value;
  statement.range = range_;
  statements_.back().push_back(std::move(statement));
}

ir::BlockId MonitorBuilder::blockOf(const std::function<void()>& body) {
  statements_.emplace_back();
  body();
  m_.blocks.push_back({std::move(statements_.back())});
  statements_.pop_back();
  return {static_cast<uint32_t>(m_.blocks.size() - 1)};
}

void MonitorBuilder::run(ExprId condition, ir::BlockId block) {
  ir::Statement statement;
  statement.kind = ir::StatementKind::If;
  statement.value = condition;
  statement.then = block;
  statement.range = range_;
  statements_.back().push_back(std::move(statement));
}

void MonitorBuilder::when(ExprId condition, const std::function<void()>& then) {
  run(condition, blockOf(then));
}

void MonitorBuilder::violation(ExprId condition, const std::string& words) {
  const auto id = make("violated", ir::VariableKind::Momentary, boolean(), {});
  when(condition, [&] { set(id, true); });
  monitor_.violations.push_back({read(id), words});
}

void MonitorBuilder::runAtEnd() {
  for (const auto& last : at_end_) {
    last();
  }
  at_end_.clear();
}

void MonitorBuilder::reset() {
  for (const Kept& kept : kept_) {
    if (kept.clock) {
      set(kept.variable, now());
      continue;
    }
    const ir::Expr first = m_[m_[kept.variable].initial];
    set(kept.variable,
        first.type == boolean() ? truth(first.op == Op::True) : number(first.number, first.type));
  }
}

void MonitorBuilder::longest(double seconds) {
  monitor_.horizon_s = std::max(monitor_.horizon_s, seconds);
}

void MonitorBuilder::finish(ir::Requirement& requirement) {
  m_.blocks.push_back({std::move(statements_.front())});
  monitor_.step = {static_cast<uint32_t>(m_.blocks.size() - 1)};
  ExprId any;
  for (const ir::Violation& violation : monitor_.violations) {
    any = any.valid() ? either(any, violation.condition) : violation.condition;
  }
  requirement.kind = ir::RequirementKind::Always;
  requirement.condition = negation(any.valid() ? any : truth(false));
  requirement.monitor = std::move(monitor_);
}

}  // namespace glider::frontend
