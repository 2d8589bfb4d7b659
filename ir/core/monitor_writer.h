// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission_writer.h"

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace glider::ir {

/// Writes the monitor of a requirement or an assumption (ir/README.md, Monitors). Statements go to
/// the block that is being written, in the order of the calls.
class MonitorWriter : private MissionWriter {
 public:
  /// `prefix` is a part of the names of all variables; `range` is that of the requirement.
  MonitorWriter(Mission& mission, const std::string& prefix, const support::SourceRange& range)
      : MissionWriter(mission, range, prefix), m_(mission), statements_(1) {}

  // Variables that are kept. All are set to their first values where `reset` is called.
  VariableId flag(const std::string& name, bool first = false);
  /// A mission time, s; `reset` sets it to the present one.
  VariableId clock(const std::string& name);
  /// A number of visits, from 0 to `most`.
  VariableId counter(const std::string& name, double most);
  /// A number of this type, 0 until it is set.
  VariableId value(const std::string& name, const Type& type);
  /// A truth value of this tick, false until it is set.
  VariableId momentary(const std::string& name);

  // Expressions.
  using MissionWriter::both;
  using MissionWriter::either;
  using MissionWriter::negation;
  using MissionWriter::now;
  using MissionWriter::number;
  using MissionWriter::operation;
  using MissionWriter::read;
  using MissionWriter::truth;
  /// Whether more than `seconds` have passed since `clock`.
  ExprId passed(VariableId clock, double seconds);
  /// What the tick did.
  ExprId observed(ObservationKind kind, StateId state = {});
  /// Whether `a` is true, which is never unknown.
  ExprId isTrue(ExprId a);

  // Statements.
  void set(VariableId variable, ExprId value);
  void set(VariableId variable, bool value) { set(variable, truth(value)); }
  /// Runs `then` where `condition` is true.
  void when(ExprId condition, const std::function<void()>& then);
  /// The requirement is violated where `condition` is true.
  void violation(ExprId condition, const std::string& words) {
    violation(condition, words, {}, "");
  }
  /// The same for what became due at the time of the clock `since`, because of `cause`: "`depth > 5
  /// m` was true".
  void violation(ExprId condition, const std::string& words, VariableId since,
                 const std::string& cause);
  /// Runs at the end of the block that is being written.
  void atEnd(std::function<void()> run) { at_end_.push_back(std::move(run)); }
  void runAtEnd();
  /// What is written by `body`, as a block for `run`: it can be placed after other statements.
  BlockId blockOf(const std::function<void()>& body);
  void run(ExprId condition, BlockId block);
  /// Sets all that was made so far to its first value.
  void reset();

  void longest(double seconds);
  void everyTick() { monitor_.every_tick = true; }

  /// Completes the requirement.
  void finish(Requirement& requirement);

 private:
  struct Kept {
    VariableId variable;
    bool clock = false;
  };
  VariableId make(const std::string& name, VariableKind kind, const Type& type, ExprId initial);

  Mission& m_;
  std::vector<std::vector<Statement>> statements_;  ///< of the blocks being written
  std::vector<Kept> kept_;
  std::vector<std::function<void()>> at_end_;
  std::map<std::pair<ObservationKind, uint32_t>, VariableId> observations_;
  Monitor monitor_;
};

}  // namespace glider::ir
