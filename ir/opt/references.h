// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

namespace glider::ir::opt {

/// The places where a mission names expressions, blocks and states. `Visitor` has `void
/// operator()(ExprId&)`, `(BlockId&)` and `(StateId&)`, which may change their argument; invalid
/// ids are left out.
template <typename Visitor>
class References {
 public:
  explicit References(Visitor& visit) : visit_(visit) {}

  void of(Block& block) {
    for (Statement& statement : block.statements) {
      name(statement.value);
      name(statement.then);
      name(statement.otherwise);
      for (ExprId& value : statement.values) {
        name(value);
      }
    }
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
  void of(Case& c) {
    name(c.guard);
    name(c.action);
    name(c.target);
    for (ExprId& argument : c.arguments) {
      name(argument);
    }
  }
  void of(Activity& activity) {
    for (ExprId& argument : activity.arguments) {
      name(argument);
    }
    name(activity.entry);
    for (Case& c : activity.cases) {
      of(c);
    }
  }
  void of(State& state) {
    of(state.profile);
    of(state.route);
    for (LogItem& item : state.log) {
      name(item.value);
    }
    name(state.entry);
    for (Case& c : state.cases) {
      of(c);
    }
  }
  void of(Requirement& requirement) {
    name(requirement.condition);
    name(requirement.monitor.step);
    for (Observation& observation : requirement.monitor.observations) {
      name(observation.state);
    }
    for (Violation& violation : requirement.monitor.violations) {
      name(violation.condition);
    }
    name(requirement.state);
    name(requirement.after);
  }
  /// References in the mission itself and in its states, not in its blocks, temporals, variables.
  void ofBody(Mission& mission) {
    for (ExprId& condition : mission.conditions) {
      name(condition);
    }
    for (Requirement& requirement : mission.requirements) {
      of(requirement);
    }
    for (Assumption& assumption : mission.assumptions) {
      of(assumption.watch);
    }
    name(mission.every_tick);
    for (Case& c : mission.always) {
      of(c);
    }
    for (State& state : mission.states) {
      of(state);
    }
  }

 private:
  template <typename Id>
  void name(Id& id) {
    if (id.valid()) {
      visit_(id);
    }
  }

  Visitor& visit_;
};

}  // namespace glider::ir::opt
