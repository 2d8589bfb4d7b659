// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/vehicle.h"

#include "vehicles/slocum/oracles/flight_judge.h"
#include "vehicles/slocum/port_flights.h"
#include "vehicles/slocum/rules/slocum_mission.h"

#include <utility>

namespace glider::vehicles {
namespace {

std::unique_ptr<simulator::Judge> makeJudge(const FlightToJudge& flight) {
  if (auto port = makePortJudge(flight)) {
    return port;
  }
  slocum::oracles::JudgeSetup setup =
      slocum::oracles::judgeSetup(flight.platform, flight.scenario, flight.kinds);
  setup.mean_W = flight.mean_W;
  return std::make_unique<slocum::oracles::FlightJudge>(std::move(setup));
}

bool promises(simulator::FaultKind kind, const simulator::Scenario& scenario) {
  return !isFlownByPort(scenario) || portPromises(kind);
}

}  // namespace

// A constant of the program: initialisers that run before main() find it complete.
constinit const Vehicle families::slocum = {.name = "slocum",
                                            .flight_computer = "flight computer",
                                            .science_computer = "science computer",
                                            .own_mission_ending = ".mi",
                                            .read_own_mission = slocum::rules::readSlocumMission,
                                            .usual_own_mission = slocum::rules::usualSlocumMission,
                                            .make_judge = makeJudge,
                                            .promises = promises};

}  // namespace glider::vehicles
