// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/opt/compact.h"
#include "ir/opt/passes.h"
#include "ir/opt/references.h"

#include <algorithm>
#include <deque>

namespace glider::ir::opt {
namespace {

/// The states that cases, including those of `always`, lead to from the first state.
std::vector<bool> reachedStates(const Mission& mission) {
  std::vector<bool> reached(mission.states.size());
  std::deque<StateId> pending;
  auto reach = [&](StateId id) {
    if (id.valid() && !reached[id.index]) {
      reached[id.index] = true;
      pending.push_back(id);
    }
  };
  reach({0});
  for (const Case& c : mission.always) {
    reach(c.target);
  }
  while (!pending.empty()) {
    const StateId id = pending.front();
    pending.pop_front();
    for (const Case& c : mission[id].cases) {
      reach(c.target);
    }
  }
  return reached;
}

struct RenumberStates {
  const std::vector<uint32_t>& numbers;

  void operator()(ExprId&) const {}
  void operator()(BlockId&) const {}
  void operator()(StateId& id) const { id.index = numbers[id.index]; }
};

/// Drops the variables of dropped states; everything that uses them is also dropped.
void dropVariables(Mission& mission, const std::vector<bool>& reached) {
  std::vector<uint32_t> numbers;
  uint32_t count = 0;
  for (const Variable& variable : mission.variables) {
    const bool stays = !variable.owner.valid() || reached[variable.owner.index];
    numbers.push_back(stays ? count++ : UINT32_MAX);
  }
  std::erase_if(mission.variables, [&](const Variable& variable) {
    return variable.owner.valid() && !reached[variable.owner.index];
  });
  auto renumber = [&](VariableId& id) { id.index = id.valid() ? numbers[id.index] : id.index; };
  for (Expr& expr : mission.exprs) {
    renumber(expr.variable);
  }
  for (Block& block : mission.blocks) {
    for (Statement& statement : block.statements) {
      renumber(statement.variable);
    }
  }
  for (State& state : mission.states) {
    std::ranges::for_each(state.parameters, renumber);
    renumber(state.profile.done);
    renumber(state.route.done);
  }
}

}  // namespace

void dropDeadStates(Mission& mission) {
  const std::vector<bool> reached = reachedStates(mission);
  std::vector<uint32_t> numbers;
  uint32_t count = 0;
  for (const bool stays : reached) {
    numbers.push_back(stays ? count++ : UINT32_MAX);
  }
  if (count == reached.size()) {
    return;
  }
  std::vector<State> states;
  for (size_t i = 0; i < reached.size(); ++i) {
    if (reached[i]) {
      states.push_back(std::move(mission.states[i]));
    }
  }
  mission.states = std::move(states);
  // First what only the dropped states used, then the variables that nothing names any more.
  for (Variable& variable : mission.variables) {
    if (variable.owner.valid() && !reached[variable.owner.index]) {
      variable.initial = {};
    }
  }
  for (Temporal& temporal : mission.temporals) {
    if (temporal.state.valid() && !reached[temporal.state.index]) {
      temporal.state = {};
    }
  }
  compact(mission);
  dropVariables(mission, reached);
  RenumberStates renumber{numbers};
  References references(renumber);
  references.ofBody(mission);
  for (Temporal& temporal : mission.temporals) {
    references.of(temporal);
  }
  for (Variable& variable : mission.variables) {
    references.of(variable);
  }
}

}  // namespace glider::ir::opt
