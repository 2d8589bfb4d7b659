// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/frontend.h"
#include "frontend/sema/declarations/choices.h"
#include "frontend/sema/declarations/declarations.h"
#include "frontend/sema/declarations/lower_assumption.h"
#include "frontend/sema/declarations/lower_declination.h"
#include "frontend/sema/declarations/lower_nap.h"
#include "frontend/sema/declarations/lower_pack.h"
#include "frontend/sema/declarations/lower_requirement.h"
#include "frontend/sema/declarations/lower_resumption.h"
#include "frontend/sema/declarations/shares.h"
#include "frontend/sema/declarations/variables.h"
#include "frontend/sema/declarations/vehicles.h"
#include "frontend/sema/names/scope.h"
#include "frontend/sema/promises/places.h"
#include "frontend/sema/states/lower_behaviour.h"
#include "frontend/sema/states/lower_case.h"
#include "frontend/sema/states/lower_state.h"
#include "platforms/load/default_platform.h"

namespace glider::frontend {

std::string platformName(const ast::File& mission) {
  for (const ast::Item& item : mission.items) {
    if (const auto* line = std::get_if<ast::PlatformLine>(&item)) {
      return line->name.text;
    }
  }
  return std::string(platforms::kDefaultPlatform);
}

std::optional<ir::Mission> analyse(const ast::File& mission, const AnalysisInputs& inputs,
                                   support::DiagnosticEngine& diagnostics, BesideMission* beside) {
  Scope scope(inputs, diagnostics);
  scope.mission.platform = inputs.platform.name;
  checkHead(mission, scope);
  for (const ast::File* library : inputs.library) {
    checkImported(*library, scope);
    declare(*library, true, scope);
  }
  declare(mission, false, scope);
  LeftOpen open = checkChoices(mission, scope);
  if (beside != nullptr) {
    beside->open = std::move(open);
  }
  declareValues(mission, scope);
  lowerVehicles(mission, scope);
  lowerShares(mission, scope);
  lowerDeclination(mission, scope);
  lowerPack(mission, inputs.library, scope);
  declareStates(mission, scope);
  declarePlaces(mission, scope);
  for (auto& [name, behaviour] : scope.behaviours) {
    if (behaviour.body != nullptr) {
      BehaviourLowering(behaviour, scope).check();
    }
  }
  lowerAlways(mission, scope);
  keepFirstCharge(scope);
  for (uint32_t i = 0; i < scope.state_declarations.size(); ++i) {
    scope.mission.states.push_back(StateLowering({i}, scope).run());
  }
  lowerRequirements(mission, scope);
  lowerAssumptions(mission, scope);
  lowerResumption(mission, scope);
  lowerNap(mission, scope);
  lowerCompass(mission, scope);
  finishShares(mission, scope);
  finishVehicles(scope);
  if (diagnostics.hasErrors()) {
    return std::nullopt;
  }
  if (beside != nullptr) {
    beside->in_c = scope.declaredInC();
  }
  warnOfReserve(scope);
  warnOfUnused(scope.names, scope);
  for (const StateDeclaration& state : scope.state_declarations) {
    warnOfUnused(state.names, scope);
  }
  return std::move(scope.mission);
}

}  // namespace glider::frontend
