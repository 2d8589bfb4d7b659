// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <functional>
#include <initializer_list>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace glider::frontend {

/// Writes the monitor of a requirement or an assumption as IR (ir/README.md, Monitors). Statements
/// go to the block that is being written, in the order of the calls.
class MonitorBuilder {
 public:
  /// `prefix` is a part of the names of all variables; `range` is that of the requirement.
  MonitorBuilder(ir::Mission& mission, std::string prefix, const support::SourceRange& range)
      : m_(mission), prefix_(std::move(prefix)), range_(range), statements_(1) {}

  // Variables that are kept. All are set to their first values where `reset` is called.
  ir::VariableId flag(const std::string& name, bool first = false);
  /// A mission time, s; `reset` sets it to the present one.
  ir::VariableId clock(const std::string& name);
  /// A number of visits, from 0 to `most`.
  ir::VariableId counter(const std::string& name, double most);
  /// A number of this type, 0 until it is set.
  ir::VariableId value(const std::string& name, const ir::Type& type);
  /// A truth value of this tick, false until it is set.
  ir::VariableId momentary(const std::string& name);

  // Expressions.
  ir::ExprId read(ir::VariableId variable);
  ir::ExprId truth(bool value);
  ir::ExprId number(double value, const ir::Type& type);
  ir::ExprId now();
  ir::ExprId negation(ir::ExprId a);
  ir::ExprId both(ir::ExprId a, ir::ExprId b);
  ir::ExprId either(ir::ExprId a, ir::ExprId b);
  ir::ExprId operation(ir::Op op, const ir::Type& type, std::initializer_list<ir::ExprId> operands);
  /// Whether more than `seconds` have passed since `clock`.
  ir::ExprId passed(ir::VariableId clock, double seconds);
  /// What the tick did.
  ir::ExprId observed(ir::ObservationKind kind, ir::StateId state = {});
  /// Whether `a` is true, which is never unknown.
  ir::ExprId isTrue(ir::ExprId a);

  // Statements.
  void set(ir::VariableId variable, ir::ExprId value);
  void set(ir::VariableId variable, bool value) { set(variable, truth(value)); }
  /// Runs `then` where `condition` is true.
  void when(ir::ExprId condition, const std::function<void()>& then);
  /// The requirement is violated where `condition` is true.
  void violation(ir::ExprId condition, const std::string& words);
  /// Runs at the end of the block that is being written.
  void atEnd(std::function<void()> run) { at_end_.push_back(std::move(run)); }
  void runAtEnd();
  /// What is written by `body`, as a block for `run`: it can be placed after other statements.
  ir::BlockId blockOf(const std::function<void()>& body);
  void run(ir::ExprId condition, ir::BlockId block);
  /// Sets all that was made so far to its first value.
  void reset();

  void longest(double seconds);
  void everyTick() { monitor_.every_tick = true; }

  /// Completes the requirement.
  void finish(ir::Requirement& requirement);

 private:
  struct Kept {
    ir::VariableId variable;
    bool clock = false;
  };
  ir::VariableId make(const std::string& name, ir::VariableKind kind, const ir::Type& type,
                      ir::ExprId initial);
  ir::ExprId push(ir::Expr expr);

  ir::Mission& m_;
  std::string prefix_;
  support::SourceRange range_;
  std::vector<std::vector<ir::Statement>> statements_;  ///< of the blocks being written
  std::vector<Kept> kept_;
  std::vector<std::function<void()>> at_end_;
  std::map<std::pair<ir::ObservationKind, uint32_t>, ir::VariableId> observations_;
  ir::Monitor monitor_;
};

}  // namespace glider::frontend
