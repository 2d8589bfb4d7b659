// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "simulator/scenario/scenario.h"
#include "support/diagnostics/show.h"
#include "support/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace glider::flights {

/// The scenarios that come with glidercc, by name.
std::vector<std::string> scenarioNames();

/// Those of them whose vehicle carries a sensor.
std::vector<std::string> scenariosWith(const platforms::Platform& platform,
                                       std::string_view sensor);

/// Loads the scenario that --scenario names, for a vehicle: a .toml file, or one that comes with
/// glidercc. Errors in it are shown. Its SBC draws what the file says, or else what the
/// board does that the platform names, in any way of running the mission: the flight is the same
/// with each. GL9302, GL4001, and as simulator::loadScenario.
support::Result<simulator::Scenario> chooseScenario(const std::string& wanted,
                                                    const platforms::Platform& platform,
                                                    const support::ShowDiagnostics& show = {});

/// Gives the vehicle of `scenario` what the mission's text says of it: the batteries of its line
/// `pack`, unless the scenario has some of its own, and as much sleep of the SBC as its line `nap
/// at most` says, if the vehicle's mission file comes with glidercc. Returns notes: that the
/// batteries hold another charge, that a mission file of one's own needs a change too.
std::vector<std::string> equipFor(const ir::Mission& mission, const platforms::Platform& platform,
                                  simulator::Scenario& scenario);

/// Makes the flights of `scenario` last up to `duration_s`, for --duration. If its mission file of
/// the vehicle is one that comes with glidercc and would end the flight sooner (overtime), that
/// time is raised too; returns a note about that, empty otherwise. The warning that another file
/// ends it sooner is not given here: the flight does.
std::string setDuration(simulator::Scenario& scenario, const platforms::Platform& platform,
                        double duration_s);

/// Whether the vehicle's mission file of `scenario` comes with glidercc.
bool hasBundledSkeleton(const simulator::Scenario& scenario);

/// Makes the vehicle of `scenario` fly another mission of its own, from `file` with what belongs to
/// it, and names that file in `scenario`. Errors in it are shown. Fails as
/// simulator::Family::load_own does.
support::Result<void> flyVehiclesOwn(const std::filesystem::path& file,
                                     const platforms::Platform& platform,
                                     simulator::Scenario& scenario,
                                     const support::ShowDiagnostics& show = {});

}  // namespace glider::flights
