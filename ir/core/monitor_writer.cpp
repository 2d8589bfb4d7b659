// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/monitor_writer.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::ir {

/// Several variables of a monitor may have one name: their numbers distinguish them.
VariableId MonitorWriter::make(const std::string& name, VariableKind kind, const Type& type,
                               ExprId initial) {
  return variable(fmt::format("{}.{}", m_.variables.size(), name), kind, type, initial);
}

VariableId MonitorWriter::flag(const std::string& name, bool first) {
  const auto id = make(name, VariableKind::Monitor, boolean(), truth(first));
  kept_.push_back({id, false});
  return id;
}

VariableId MonitorWriter::clock(const std::string& name) {
  const Type time = quantity(support::dimension::time);
  const auto id = make(name, VariableKind::Monitor, time, number(0, time));
  kept_.push_back({id, true});
  return id;
}

VariableId MonitorWriter::counter(const std::string& name, double most) {
  const auto id = make(name, VariableKind::Monitor, plainNumber(), number(0, plainNumber()));
  m_.variables[id.index].lowest = 0;
  m_.variables[id.index].highest = most;
  kept_.push_back({id, false});
  return id;
}

VariableId MonitorWriter::value(const std::string& name, const Type& type) {
  const auto id = make(name, VariableKind::Monitor, type, number(0, type));
  kept_.push_back({id, false});
  return id;
}

VariableId MonitorWriter::momentary(const std::string& name) {
  const auto id = make(name, VariableKind::Momentary, boolean(), {});
  set(id, false);
  return id;
}

ExprId MonitorWriter::passed(VariableId clock, double seconds) {
  const Type time = quantity(support::dimension::time);
  const ExprId present = now();
  const ExprId since = read(clock);
  const ExprId gone = operation(Op::Subtract, time, {present, since});
  return operation(Op::Greater, boolean(), {gone, number(seconds, time)});
}

ExprId MonitorWriter::observed(ObservationKind kind, StateId state) {
  const auto [found, made] = observations_.try_emplace({kind, state.index});
  if (made) {
    const char* what = kind == ObservationKind::Entered  ? "entered"
                       : kind == ObservationKind::Inside ? "inside"
                                                         : "ended";
    found->second = make(what, VariableKind::Momentary, boolean(), {});
    monitor_.observations.push_back({found->second, kind, state});
  }
  return read(found->second);
}

ExprId MonitorWriter::isTrue(ExprId a) {
  const VariableId known = momentary("is");
  when(a, [&] { set(known, true); });
  return read(known);
}

void MonitorWriter::set(VariableId variable, ExprId value) {
  statements_.back().push_back(assignment(variable, value));
}

BlockId MonitorWriter::blockOf(const std::function<void()>& body) {
  statements_.emplace_back();
  body();
  const BlockId block = add(Block{std::move(statements_.back())});
  statements_.pop_back();
  return block;
}

void MonitorWriter::run(ExprId condition, BlockId block) {
  statements_.back().push_back(branch(condition, block));
}

void MonitorWriter::when(ExprId condition, const std::function<void()>& then) {
  run(condition, blockOf(then));
}

void MonitorWriter::violation(ExprId condition, const std::string& words, VariableId since,
                              const std::string& cause) {
  const auto id = make("violated", VariableKind::Momentary, boolean(), {});
  when(condition, [&] { set(id, true); });
  monitor_.violations.push_back({read(id), words, since, cause});
}

void MonitorWriter::runAtEnd() {
  for (const auto& last : at_end_) {
    last();
  }
  at_end_.clear();
}

void MonitorWriter::reset() {
  for (const Kept& kept : kept_) {
    if (kept.clock) {
      set(kept.variable, now());
      continue;
    }
    const Expr first = m_[m_[kept.variable].initial];
    set(kept.variable,
        first.type == boolean() ? truth(first.op == Op::True) : number(first.number, first.type));
  }
}

void MonitorWriter::longest(double seconds) {
  monitor_.horizon_s = std::max(monitor_.horizon_s, seconds);
}

void MonitorWriter::finish(Requirement& requirement) {
  monitor_.step = add(Block{std::move(statements_.front())});
  ExprId any;
  for (const Violation& violation : monitor_.violations) {
    any = any.valid() ? either(any, violation.condition) : violation.condition;
  }
  requirement.kind = RequirementKind::Always;
  requirement.condition = negation(any.valid() ? any : truth(false));
  requirement.monitor = std::move(monitor_);
}

}  // namespace glider::ir
