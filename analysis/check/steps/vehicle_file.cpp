// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/check/run.h"
#include "flights/scenario_choice.h"
#include "support/diagnostics/ids/vehicle.h"
#include "vehicles/vehicle.h"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace glider::analysis::check {

/// Reads the vehicle's mission file, if the options name one, or a scenario that has one; else
/// takes what is usual for its family.
support::Result<void> vehicleFile(Run& run) {
  const bool of_scenario = run.options.own_mission.empty() && !run.options.scenario.empty() &&
                           run.scenario->own.has_value();
  const std::string path =
      of_scenario ? run.scenario->skeleton_path.string() : run.options.own_mission;
  if (path.empty()) {
    const vehicles::Vehicle* family = vehicles::vehicleOf(run.platform());
    run.file.own_mission = family == nullptr ? nullptr : family->usual_own_mission();
    return {};
  }
  const vehicles::Vehicle* mine = vehicles::vehicleOf(run.platform());
  const vehicles::Vehicle& of_file = vehicles::vehicleOfFile(path, mine);
  if (!of_scenario && mine != nullptr && mine != &of_file) {
    return support::fail(support::diagnostics::skeletonErrors, path,
                         fmt::format("it is for vehicles of the family `{}`, and `{}` is of `{}`",
                                     of_file.name, run.platform().name, mine->name));
  }
  // Its errors were shown when it was read first.
  const vehicles::Vehicle& family = of_scenario && mine != nullptr ? *mine : of_file;
  auto own = family.read_own_mission(path, *run.file.compilation->sources, {});
  if (!own) {
    return std::unexpected(own.error());
  }
  run.file.own_mission = std::move(*own);
  if (of_scenario && run.options.duration_s && flights::hasBundledSkeleton(*run.scenario)) {
    (void)run.file.own_mission->raiseOvertime(*run.options.duration_s);  // as the scenario's was
  }
  return {};
}

}  // namespace glider::analysis::check
