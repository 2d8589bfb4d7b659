// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/vehicle.h"

#include "simulator/remus100/timeout.h"
#include "support/diagnostics/ids/vehicle.h"
#include "vehicles/floats_home.h"
#include "vehicles/remus100/remus_judge.h"

#include <memory>

namespace glider::vehicles {
namespace {

support::Result<std::unique_ptr<OwnMission>> readOwnMission(
    const std::string& path, support::SourceManager& /*sources*/,
    const support::ShowDiagnostics& /*show*/) {
  return support::fail(
      support::diagnostics::badDataFile, path,
      "the own mission of a REMUS cannot be read: it is not checked beside a mission");
}

std::unique_ptr<OwnMission> usualOwnMission() {
  return floatsHome({.timeout_s = simulator::remus100::kTimeoutSecs,
                     .first = "is assumed to end the override",
                     .timeout = "a time-out that RECON does not state: set it on the vehicle"});
}

std::unique_ptr<simulator::Judge> makeJudge(const FlightToJudge& flight) {
  return std::make_unique<remus100::RemusJudge>(
      promiseOf(simulator::remus100::kTimeoutSecs, flight.platform));
}

}  // namespace

constinit const Vehicle families::remus100 = {.name = "remus100",
                                              .flight_computer = "vehicle",
                                              .science_computer = "vehicle",
                                              .own_mission_ending = ".rmf",
                                              .read_own_mission = readOwnMission,
                                              .usual_own_mission = usualOwnMission,
                                              .make_judge = makeJudge,
                                              .promises = promisesOfFloating};

}  // namespace glider::vehicles
