// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/unit/campaign/small_plan.h"

#include "tests/unit/simulator/fake_sbc.h"
#include "tests/unit/simulator/flights.h"

namespace glider::campaign::testing {
namespace {

simulator::StartSbc pilot() {
  return [] {
    return support::Result<std::unique_ptr<simulator::SbcPort>>(
        std::make_unique<simulator::FakeSbc>(
            simulator::FakePilot::Plan{.release_s = 600, .takes_again = true}, 1e9, true));
  };
}

}  // namespace

CampaignPlan smallPlan(uint64_t flights) {
  simulator::SimulationSetup setup = simulator::shippedSetup("default");
  CampaignPlan plan;
  plan.scenario = std::move(setup.scenario);
  plan.kinds = {simulator::FaultKind::None};
  plan.flights = flights;
  for (const char* file : {"one.mission", "two.mission"}) {
    CampaignMission& mission = plan.missions.emplace_back();
    mission.file = file;
    mission.platform = setup.platform;
    mission.vehicle = plan.scenario.vehicle;
    mission.new_flight = pilot;
  }
  return plan;
}

CampaignListener deaf() {
  return {[](const CampaignFlight&, const simulator::Verdict&) { return support::Result<void>(); },
          [](uint64_t) {}, [] { return false; }};
}

simulator::Verdict known(double number) {
  simulator::Verdict verdict;
  verdict.outcome = simulator::Verdict::Outcome::Exited;
  verdict.end_s = number;
  verdict.deepest_m = -number;
  return verdict;
}

}  // namespace glider::campaign::testing
