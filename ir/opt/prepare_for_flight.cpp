// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/opt/prepare_for_flight.h"

#include "ir/core/references.h"
#include "ir/core/walk.h"
#include "ir/opt/compact.h"
#include "ir/opt/keep.h"

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace glider::ir {
namespace {

/// Makes the watches of assumptions a part of what flies.
class OnBoard {
 public:
  explicit OnBoard(Mission& mission) : m_(mission) {}

  void run() {
    if (std::ranges::none_of(m_.assumptions, &Assumption::isWatched)) {
      return;
    }
    if (m_.every_tick.valid()) {
      statements_ = std::move(m_.blocks[m_.every_tick.index].statements);
    }
    telling_ = flag("assumption.telling");
    statements_.push_back(set(telling_, Op::False));
    for (size_t i = 0; i < m_.assumptions.size(); ++i) {
      if (m_.assumptions[i].isWatched()) {
        watch(i);
      }
    }
    m_.every_tick = add({std::move(statements_)});
  }

 private:
  /// The monitor's statements, then the note. A tick tells of one broken assumption only, because
  /// it has room for so many notes (GLIDER_MOST_NOTES), and the mission's own come after these.
  void watch(size_t number) {
    const Assumption& assumption = m_.assumptions[number];
    const BlockId step = assumption.watch.monitor.step;
    for (const uint32_t variable : variablesOf(assumption.watch)) {
      keepVariable({variable});
    }
    if (step.valid()) {
      std::ranges::move(m_.blocks[step.index].statements, std::back_inserter(statements_));
    }
    const std::string name = "assumption " + std::to_string(number + 1);
    const VariableId broken = flag(name + ".broken");
    const VariableId told = flag(name + ".told");
    statements_.push_back(
        when(negated(assumption.watch.condition), add({{set(broken, Op::True)}})));
    Statement log;
    log.kind = StatementKind::Log;
    log.text = brokenAssumption(assumption);
    log.range = assumption.range;
    const ExprId silent = push(Op::And, {negated(read(told)), negated(read(telling_))});
    const ExprId news = push(Op::And, {read(broken), silent});
    statements_.push_back(
        when(news, add({{set(told, Op::True), set(telling_, Op::True), std::move(log)}})));
  }

  std::set<uint32_t> variablesOf(const Requirement& watched) {
    std::set<uint32_t> found;
    const auto look = [&](ExprId id) {
      forEachIn(m_, id, [&](const Expr& e) {
        if (e.op == Op::Variable) {
          found.insert(e.variable.index);
        }
      });
    };
    look(watched.condition);
    forEachStatement(m_, watched.monitor.step, [&](const Statement& statement) {
      look(statement.value);
      if (statement.variable.valid()) {
        found.insert(statement.variable.index);
      }
    });
    return found;
  }

  /// A momentary variable is false until the monitor sets it, instead of unknown: no monitor of an
  /// assumption asks for more than whether it is true.
  void keepVariable(VariableId id) {
    const VariableKind kind = m_[id].kind;
    if (!isOfMonitor(kind)) {
      return;
    }
    m_.variables[id.index].kind = VariableKind::Mission;
    if (kind == VariableKind::Momentary) {
      m_.variables[id.index].initial = push(Op::False, {});
      statements_.push_back(set(id, Op::False));
    }
  }

  // --- parts ---

  VariableId flag(std::string name) {
    Variable variable;
    variable.name = std::move(name);
    variable.type = kBool;
    variable.initial = push(Op::False, {});
    m_.variables.push_back(std::move(variable));
    return {static_cast<uint32_t>(m_.variables.size() - 1)};
  }

  ExprId read(VariableId variable) {
    const ExprId id = push(Op::Variable, {});
    m_.exprs[id.index].variable = variable;
    return id;
  }

  ExprId negated(ExprId truth) { return push(Op::Not, {truth}); }

  ExprId push(Op op, std::initializer_list<ExprId> operands) {
    Expr expr;
    expr.op = op;
    expr.type = kBool;
    std::ranges::copy(operands, expr.operands.begin());
    m_.exprs.push_back(expr);
    return {static_cast<uint32_t>(m_.exprs.size() - 1)};
  }

  Statement set(VariableId variable, Op truth) {
    Statement statement;
    statement.variable = variable;
    statement.value = push(truth, {});
    return statement;
  }

  static Statement when(ExprId condition, BlockId then) {
    Statement statement;
    statement.kind = StatementKind::If;
    statement.value = condition;
    statement.then = then;
    return statement;
  }

  BlockId add(Block block) {
    m_.blocks.push_back(std::move(block));
    return {static_cast<uint32_t>(m_.blocks.size() - 1)};
  }

  static constexpr Type kBool{TypeKind::Bool, {}};
  Mission& m_;
  std::vector<Statement> statements_;
  VariableId telling_;  ///< whether this tick has left a note about one
};

void dropUnusedSensors(Mission& mission) {
  std::vector<bool> used(mission.sensors.size());
  const auto use = [&](const SensorId& id) { used[id.index] = true; };
  References(use).of(mission);
  const std::vector<uint32_t> numbers = opt::keep(mission.sensors, used);
  const auto renumber = [&](SensorId& id) { id.index = numbers[id.index]; };
  References(renumber).of(mission);
}

/// What still names one of them is dropped afterwards.
void dropMonitorVariables(Mission& mission) {
  std::vector<bool> flies;
  for (const Variable& variable : mission.variables) {
    flies.push_back(!isOfMonitor(variable.kind));
  }
  const std::vector<uint32_t> numbers = opt::keep(mission.variables, flies);
  const auto renumber = [&](VariableId& id) { id.index = numbers[id.index]; };
  References(renumber).of(mission);
}

}  // namespace

void prepareForFlight(Mission& mission) {
  if (mission.requirements.empty() && mission.assumptions.empty()) {
    return;
  }
  OnBoard(mission).run();
  mission.requirements.clear();
  mission.assumptions.clear();
  dropMonitorVariables(mission);
  opt::compact(mission);
  dropUnusedSensors(mission);
}

std::string brokenAssumption(const Assumption& assumption) {
  return "assumption broken: " + assumption.words;
}

}  // namespace glider::ir
