// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "driver/sbc_choice.h"
#include "simulator/campaign/draw_faults.h"
#include "simulator/campaign/flight_judge.h"
#include "simulator/simulator.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace glider::driver {

/// A mission of a campaign, ready to start as often as wanted.
struct CampaignMission {
  std::string file;
  NewFlight new_flight;
  double flight_s = 0;  ///< how long it flies when nothing goes wrong
};

/// What all flights of a campaign share.
struct CampaignPlan {
  platforms::Platform platform;
  simulator::Scenario scenario;
  std::vector<CampaignMission> missions;
  uint64_t flights = 0;
  uint64_t seed = 1;
  unsigned jobs = 1;
};

/// One flight of a campaign: the plan and its number say all of it.
struct CampaignFlight {
  uint64_t number = 0;
  size_t mission = 0;  ///< of the plan
  simulator::FaultKind kind = simulator::FaultKind::None;
  uint64_t seed = 0;
};
/// Missions and kinds of faults take turns.
CampaignFlight flightOf(const CampaignPlan& plan, uint64_t number);

/// Everything for flight `flight` but who looks on. As StartSbc.
support::Result<simulator::SimulationSetup> setupOf(const CampaignPlan& plan,
                                                    const CampaignFlight& flight);

/// Flies it, judged; the trace goes to `trace` unless that is null. As StartSbc and simulate.
support::Result<simulator::Verdict> flyOne(const CampaignPlan& plan, const CampaignFlight& flight,
                                           support::Trace* trace = nullptr);

/// Flies each mission once with nothing wrong and notes how long that takes.
support::Result<void> measureMissions(CampaignPlan& plan);

struct CampaignResult {
  std::vector<simulator::Verdict> verdicts;  ///< one a flight, by number
  std::optional<support::Failure> failure;   ///< of the world: the rest was not flown
  bool hung = false;                         ///< a flight did not come back: its thread still runs
};

/// Flies all. `progress` is called a few times a second with the number of flights that are over. A
/// flight that takes longer than a minute of real time hangs: its verdict says so and the rest is
/// left.
CampaignResult flyAll(const CampaignPlan& plan, const std::function<void(uint64_t)>& progress);

}  // namespace glider::driver
