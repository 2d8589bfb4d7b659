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
namespace {

/// Reads the vehicle's mission file, if the options name one, or a scenario that has one; else
/// takes what is usual for its family.
support::Result<void> readFile(Run& run) {
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
  return {};
}

/// Makes the flight of the scenario as long as the options say, and what is checked of the file
/// agree with what flies.
void setDuration(Run& run) {
  const double duration_s = *run.options.duration_s;
  const std::string note =
      flights::setDuration(*run.scenario, run.checked().platform(), duration_s);
  if (!note.empty()) {
    run.remark(note);
  }
  if (run.file.own_mission != nullptr && flights::hasBundledSkeleton(*run.scenario)) {
    (void)run.file.own_mission->raiseOvertime(duration_s);
  }
}

/// What is proved holds for a vehicle that obeys as its own mission lets it.
support::Result<void> widen(Run& run) {
  const vehicles::OwnMission* own = run.file.own_mission.get();
  if (own == nullptr) {
    return {};
  }
  if (const std::string why = own->whyNotFlown(); !why.empty() && !run.options.scenario.empty()) {
    return support::fail(support::diagnostics::skeletonErrors, run.options.own_mission, why);
  }
  auto& checked = run.file.compilation->checked;
  checked = compiler::onVehicle(*checked, [&](platforms::Platform& vehicle) {
    own->widen(vehicle, run.mission().resume_within_s);
  });
  run.file.compilation->lowered = checked->lowered;
  return {};
}

}  // namespace

/// Reads the vehicle's mission file, which also flies in the scenario, for as long as the options
/// say.
support::Result<void> vehicleFile(Run& run) {
  if (auto read = readFile(run); !read) {
    return read;
  }
  if (auto obeyed = widen(run); !obeyed) {
    return obeyed;
  }
  const CheckOptions& options = run.options;
  if (!options.own_mission.empty() && !options.scenario.empty()) {
    if (auto own =
            flights::flyVehiclesOwn(options.own_mission, run.checked().platform(), *run.scenario);
        !own) {
      return own;
    }
  }
  if (run.scenario && options.duration_s) {
    setDuration(run);
  }
  return {};
}

}  // namespace glider::analysis::check
