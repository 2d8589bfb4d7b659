// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/trial_flight.h"

#include "analysis/check/run.h"
#include "flights/scenario_choice.h"
#include "support/units/duration_text.h"

#include <fmt/format.h>

#include <string>

namespace glider::analysis::check {

/// Flies the mission in the scenario that the options name, if nothing is wrong so far.
support::Result<void> trialFlight(Run& run) {
  const CheckOptions& options = run.options;
  if (options.scenario.empty() || run.diagnostics().hasErrors()) {
    return {};
  }
  run.observer.at("flying in the scenario");
  std::string command =
      fmt::format("glidercc sim {} --scenario {}", run.file.found.path, options.scenario);
  if (!options.own_mission.empty()) {
    command += " --mi " + options.own_mission;
  }
  if (options.duration_s) {
    command += " --duration " + support::durationArgument(*options.duration_s);
  }
  return reportTrialFlight(run.optimised(), *run.scenario, options.user_code,
                           fmt::format("see the flight with `{}`", command), run.diagnostics());
}

}  // namespace glider::analysis::check
