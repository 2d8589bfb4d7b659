// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/pilot_name.h"

namespace glider::ir {
namespace {

bool isOfBehaviour(const Variable& variable) {
  return variable.owner.valid() &&
         (variable.kind == VariableKind::Profile || variable.kind == VariableKind::Route);
}

/// Whether it says that the profile or route is done.
bool saysDone(const State& state, VariableId id) {
  return state.profile.done == id || state.route.done == id;
}

}  // namespace

bool isInner(const Mission& mission, VariableId id) {
  const Variable& variable = mission[id];
  return isOfBehaviour(variable) && !saysDone(mission[variable.owner], id) &&
         variable.range.valid() && variable.range.file != mission[variable.owner].range.file;
}

std::string pilotName(const Mission& mission, VariableId id) {
  const Variable& variable = mission[id];
  if (!isOfBehaviour(variable)) {
    return variable.name;
  }
  const State& state = mission[variable.owner];
  const bool profile = variable.kind == VariableKind::Profile;
  if (saysDone(state, id)) {
    return (profile ? "profiledone in " : "routedone in ") + state.name;
  }
  return isInner(mission, id)
             ? (profile ? "the flightprofile of " : "the flightroute of ") + state.name
             : variable.name;
}

}  // namespace glider::ir
