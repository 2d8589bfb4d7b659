// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/vehicle.h"

#include "runtime/imc/usual.h"
#include "support/diagnostics/ids/vehicle.h"
#include "vehicles/floats_home.h"
#include "vehicles/lauv/lauv_judge.h"

#include <memory>

namespace glider::vehicles {
namespace {

support::Result<std::unique_ptr<OwnMission>> readOwnMission(
    const std::string& path, support::SourceManager& /*sources*/,
    const support::ShowDiagnostics& /*show*/) {
  return support::fail(support::diagnostics::badDataFile, path,
                       "a LAUV flies nothing by itself that could be checked beside a mission");
}

std::unique_ptr<OwnMission> usualOwnMission() {
  return floatsHome({.timeout_s = runtime::imc::kTimeoutSecs,
                     .first = "stops its propeller",
                     .timeout = "the time-out of the plan"});
}

std::unique_ptr<simulator::Judge> makeJudge(const FlightToJudge& flight) {
  return std::make_unique<lauv::LauvJudge>(promiseOf(runtime::imc::kTimeoutSecs, flight.platform));
}

}  // namespace

constinit const Vehicle families::lauv = {.name = "lauv",
                                          .flight_computer = "vehicle",
                                          .science_computer = "vehicle",
                                          .own_mission_ending = ".ini",
                                          .read_own_mission = readOwnMission,
                                          .usual_own_mission = usualOwnMission,
                                          .make_judge = makeJudge,
                                          .promises = promisesOfFloating};

}  // namespace glider::vehicles
