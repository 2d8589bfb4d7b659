// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/check/run.h"
#include "analysis/start_place.h"
#include "flights/scenario_choice.h"

#include <utility>

namespace glider::analysis::check {

/// Loads the scenario, the usual one if none is named, and warns of a start that the mission does
/// not assume. Fails if the one that is named cannot be loaded.
support::Result<void> scenario(Run& run) {
  const std::string& named = run.options.scenario;
  auto loaded = flights::chooseScenario(named.empty() ? "default" : named, run.checked().platform(),
                                        [&](const auto& diagnostics, const auto& sources) {
                                          run.observer.show(diagnostics, sources);
                                        });
  if (loaded) {
    run.scenario = std::move(*loaded);
  } else if (!named.empty()) {
    return std::unexpected(loaded.error());
  }
  if (!named.empty()) {
    checkStart(run.checked(),
               {"scenario `" + run.scenario->name + "`",
                {run.scenario->latitude_deg, run.scenario->longitude_deg}},
               run.diagnostics());
  }
  return {};
}

}  // namespace glider::analysis::check
