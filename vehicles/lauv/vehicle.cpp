// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/vehicle.h"

#include "support/diagnostics/ids/vehicle.h"
#include "vehicles/lauv/lauv_judge.h"
#include "vehicles/lauv/usual_lauv.h"

#include <algorithm>
#include <iterator>

namespace glider::vehicles {
namespace {

support::Result<std::unique_ptr<OwnMission>> readOwnMission(
    const std::string& path, support::SourceManager& /*sources*/,
    const support::ShowDiagnostics& /*show*/) {
  return support::fail(support::diagnostics::badDataFile, path,
                       "a LAUV flies nothing by itself that could be checked beside a mission");
}

std::unique_ptr<simulator::Judge> makeJudge(const FlightToJudge& flight) {
  const platforms::Platform& platform = flight.platform;
  return std::make_unique<lauv::LauvJudge>(
      lauv::LauvPromise{.greatest_depth_m = platform.envelope.greatest_depth_m,
                        .overshoot_m = platform.envelope.inflection_overshoot_m,
                        .lets_go_s = lauv::letsGoWithin(platform),
                        .turn_s = platform.world.turn_s,
                        .rises_m_s = platform.world.slowest_climb_m_s});
}

/// Faults of the SBC, of its line and of the vehicle's computer. Those of hooks, of a science
/// computer and of their line are none that this vehicle can have.
bool promises(simulator::FaultKind kind, const simulator::Scenario& /*scenario*/) {
  using simulator::FaultKind;
  constexpr FaultKind kPromised[] = {
      FaultKind::None,  FaultKind::ByteLoss,    FaultKind::BitFlips,      FaultKind::Bursts,
      FaultKind::Delay, FaultKind::HalfOpen,    FaultKind::LineCut,       FaultKind::Port,
      FaultKind::Power, FaultKind::Checkpoints, FaultKind::FlightRestart, FaultKind::ShallowWater};
  return std::ranges::find(kPromised, kind) != std::end(kPromised);
}

}  // namespace

constinit const Vehicle families::lauv = {.name = "lauv",
                                          .own_mission_ending = ".ini",
                                          .read_own_mission = readOwnMission,
                                          .usual_own_mission = glider::lauv::usualLauv,
                                          .make_judge = makeJudge,
                                          .promises = promises};

}  // namespace glider::vehicles
