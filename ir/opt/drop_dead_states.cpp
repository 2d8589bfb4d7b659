// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/references.h"
#include "ir/opt/compact.h"
#include "ir/opt/keep.h"
#include "ir/opt/passes.h"

#include <algorithm>
#include <deque>
#include <utility>
#include <vector>

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

/// Of the states and variables that stay; nothing names the others any more.
struct RenumberStates {
  std::vector<uint32_t> states;
  std::vector<uint32_t> variables;

  void operator()(StateId& id) const { id.index = states[id.index]; }
  void operator()(VariableId& id) const { id.index = variables[id.index]; }
};

/// For each variable, whether it belongs to no state or to one that stays.
std::vector<bool> variablesOf(const Mission& mission, const std::vector<bool>& reached) {
  std::vector<bool> stays;
  for (const Variable& variable : mission.variables) {
    stays.push_back(!variable.owner.valid() || reached[variable.owner.index]);
  }
  return stays;
}

}  // namespace

void dropDeadStates(Mission& mission) {
  const std::vector<bool> reached = reachedStates(mission);
  if (std::ranges::find(reached, false) == reached.end()) {
    return;
  }
  std::vector<uint32_t> states = keep(mission.states, reached);
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
  const RenumberStates renumber{std::move(states),
                                keep(mission.variables, variablesOf(mission, reached))};
  References(renumber).of(mission);
}

}  // namespace glider::ir::opt
