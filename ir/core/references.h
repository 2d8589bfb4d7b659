// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <concepts>

namespace glider::ir {

/// The places where a mission names something by its number. `Visitor` has `void
/// operator()(ExprId&)` and the same for other kinds of numbers, which may change their argument;
/// kinds that it does not take, and invalid numbers, are left out.
template <typename Visitor>
class References {
 public:
  /// `visit` outlives this.
  explicit References(Visitor& visit) : visit_(visit) {}

  void of(Expr& expr) {
    ofEach(expr.operands);
    name(expr.sensor);
    name(expr.variable);
    name(expr.temporal);
    name(expr.table);
    name(expr.use);
  }
  void of(Block& block) { ofEach(block.statements); }
  void of(Statement& statement) {
    name(statement.variable);
    name(statement.value);
    name(statement.then);
    name(statement.otherwise);
    ofEach(statement.values);
  }
  void of(Temporal& temporal) {
    name(temporal.operand);
    name(temporal.duration);
    name(temporal.along);
    name(temporal.state);
  }
  void of(Variable& variable) {
    name(variable.initial);
    name(variable.owner);
  }
  void of(FunctionUse& use) { name(use.function); }
  void of(Behaviour& behaviour) { ofEach(behaviour.reads); }
  void of(Case& c) {
    name(c.guard);
    name(c.action);
    name(c.target);
    ofEach(c.arguments);
  }
  void of(GuardTable& table) {
    for (GuardColumn& column : table.columns) {
      name(column.sensor);
    }
  }
  void of(Activity& activity) {
    name(activity.behaviour);
    ofEach(activity.arguments);
    name(activity.entry);
    ofEach(activity.cases);
    name(activity.done);
  }
  void of(State& state) {
    of(state.profile);
    of(state.route);
    ofEach(state.parameters);
    for (LogItem& item : state.log) {
      name(item.value);
    }
    for (Sampling& sampling : state.sampling) {
      name(sampling.code);
      name(sampling.period);
    }
    name(state.entry);
    ofEach(state.cases);
    of(state.table);
  }
  void of(Requirement& requirement) {
    name(requirement.condition);
    name(requirement.monitor.step);
    for (Observation& observation : requirement.monitor.observations) {
      name(observation.variable);
      name(observation.state);
    }
    for (Violation& violation : requirement.monitor.violations) {
      name(violation.condition);
      name(violation.since);
    }
    name(requirement.state);
    name(requirement.after);
  }
  void of(Assumption& assumption) {
    name(assumption.sensor);
    of(assumption.watch);
  }
  void of(Share& share) {
    name(share.sensor);
    name(share.variable);
    name(share.peer);
    for (FromVehicle& from : share.named) {
      name(from.sensor);
    }
  }
  /// In the mission itself and in its states; not in what has a number of its own and may not be
  /// used: expressions, blocks, temporals, variables, and uses of functions.
  void ofBody(Mission& mission) {
    ofEach(mission.behaviours);
    ofEach(mission.conditions);
    ofEach(mission.requirements);
    ofEach(mission.assumptions);
    name(mission.every_tick);
    ofEach(mission.always);
    of(mission.always_table);
    ofEach(mission.states);
    if (mission.compass) {
      name(mission.compass->variation);
    }
    ofEach(mission.shares);
    name(mission.utc);
  }
  void of(Mission& mission) {
    ofEach(mission.exprs);
    ofEach(mission.blocks);
    ofEach(mission.temporals);
    ofEach(mission.variables);
    ofEach(mission.uses);
    ofBody(mission);
  }

 private:
  template <typename List>
  void ofEach(List& list) {
    for (auto& element : list) {
      if constexpr (requires { element.index; }) {
        name(element);
      } else {
        of(element);
      }
    }
  }

  template <typename Tag>
  void name(Id<Tag>& id) {
    if constexpr (std::invocable<Visitor&, Id<Tag>&>) {
      if (id.valid()) {
        visit_(id);
      }
    }
  }

  Visitor& visit_;
};

}  // namespace glider::ir
