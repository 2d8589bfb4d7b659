// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/frontend.h"
#include "frontend/sema/declarations.h"
#include "frontend/sema/lower_state.h"
#include "frontend/sema/scope.h"

namespace glider::frontend {

using support::DiagnosticId;

std::string platformName(const ast::File& mission) {
  for (const ast::Item& item : mission.items) {
    if (const auto* line = std::get_if<ast::PlatformLine>(&item)) {
      return line->name.text;
    }
  }
  return "slocum";
}

namespace {

/// Numbers the states, so that cases may name those that come later.
std::vector<const ast::State*> enterStates(const ast::File& file, Scope& scope) {
  std::vector<const ast::State*> states;
  for (const ast::Item& item : file.items) {
    const auto* state = std::get_if<ast::State>(&item);
    if (state == nullptr) {
      continue;
    }
    const ir::StateId id{static_cast<uint32_t>(states.size())};
    const auto [place, fresh] = scope.states.emplace(state->name.text, id);
    if (fresh) {
      states.push_back(state);
    } else {
      scope.report(DiagnosticId::duplicateName, state->name.where, state->name.text)
          .note(states[place->second.index]->name.where, "the first is here");
    }
  }
  return states;
}

}  // namespace

std::optional<ir::Mission> analyse(const ast::File& mission, const AnalysisInputs& inputs,
                                   support::DiagnosticEngine& diagnostics) {
  Scope scope(inputs, diagnostics);
  scope.mission.platform = inputs.platform.name;
  checkHead(mission, scope);
  for (const ast::File* library : inputs.library) {
    checkImported(*library, scope);
    declare(*library, true, scope);
  }
  declare(mission, false, scope);
  for (const ast::State* state : enterStates(mission, scope)) {
    scope.mission.states.push_back(StateLowering(*state, scope).run());
  }
  if (diagnostics.hasErrors()) {
    return std::nullopt;
  }
  return std::move(scope.mission);
}

}  // namespace glider::frontend
