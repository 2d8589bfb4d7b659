// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/opt/prepare_for_flight.h"

#include "ir/core/mission_writer.h"
#include "ir/core/references.h"
#include "ir/core/walk.h"
#include "ir/opt/compact.h"
#include "ir/opt/keep.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace glider::ir {
namespace {

/// Makes the watches of assumptions a part of what flies.
class OnBoard {
 public:
  explicit OnBoard(Mission& mission) : m_(mission), write_(mission) {}

  void run() {
    if (std::ranges::none_of(m_.assumptions, &Assumption::isWatched)) {
      return;
    }
    if (m_.every_tick.valid()) {
      statements_ = std::move(m_.blocks[m_.every_tick.index].statements);
    }
    telling_ = write_.flag("assumption.telling", VariableKind::Mission);
    statements_.push_back(set(telling_, false));
    for (size_t i = 0; i < m_.assumptions.size(); ++i) {
      if (m_.assumptions[i].isWatched()) {
        watch(i);
      }
    }
    m_.every_tick = write_.add(Block{std::move(statements_)});
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
    const VariableId broken = write_.flag(name + ".broken", VariableKind::Mission);
    const VariableId told = write_.flag(name + ".told", VariableKind::Mission);
    const BlockId breaks = write_.add(Block{{set(broken, true)}});
    statements_.push_back(write_.branch(write_.negation(assumption.watch.condition), breaks));
    Statement log;
    log.kind = StatementKind::Log;
    log.text = brokenAssumption(assumption);
    log.range = assumption.range;
    const ExprId untold = write_.negation(write_.read(told));
    const ExprId silent = write_.both(untold, write_.negation(write_.read(telling_)));
    const ExprId news = write_.both(write_.read(broken), silent);
    const Block note{{set(told, true), set(telling_, true), std::move(log)}};
    statements_.push_back(write_.branch(news, write_.add(note)));
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
      m_.variables[id.index].initial = write_.truth(false);
      statements_.push_back(set(id, false));
    }
  }

  Statement set(VariableId variable, bool value) {
    return write_.assignment(variable, write_.truth(value));
  }

  Mission& m_;
  MissionWriter write_;
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
