// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "flights/sbc_choice.h"
#include "simulator/campaign/draw_faults.h"
#include "simulator/campaign/flight_judge.h"
#include "simulator/simulator.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace glider::campaign {

/// A mission of a campaign, ready to start as often as wanted.
struct CampaignMission {
  std::string file;
  std::string program;           ///< a digest of what is compiled from it, imports and all
  platforms::Platform platform;  ///< that it names
  flights::NewFlight new_flight;
  std::vector<flights::NewFlight> on_board;  ///< one for each of the plan's boards
  simulator::FlightTimes times = {};         ///< of its flight when nothing goes wrong
  double mean_W = 0;                         ///< that its batteries give then
};

/// What all flights of a campaign share.
struct CampaignPlan {
  simulator::Scenario scenario;
  std::vector<CampaignMission> missions;
  std::vector<std::string> boards;  ///< whose binaries fly
  unsigned board_percent = 0;       ///< of the flights; the others fly in this process
  std::vector<simulator::FaultKind> kinds = simulator::allFaultKinds();  ///< drawn in turn
  uint64_t flights = 0;
  uint64_t seed = 1;
  unsigned jobs = 1;
  double hang_s = 60, hang_on_board_s = 600;  ///< of real time; what takes longer hangs
};

/// One flight of a campaign: the plan and its number say all of it.
struct CampaignFlight {
  uint64_t number = 0;
  size_t mission = 0;  ///< of the plan
  simulator::FaultKind kind = simulator::FaultKind::None;
  simulator::Manner manner = simulator::Manner::Once;
  uint64_t seed = 0;
  std::optional<size_t> board;  ///< of the plan; none: in this process
};
/// Missions, kinds of faults and manners take turns; the seed chooses the board.
CampaignFlight flightOf(const CampaignPlan& plan, uint64_t number);
/// What goes wrong in it.
simulator::DrawnFaults faultsOf(const CampaignPlan& plan, const CampaignFlight& flight);

/// Flies it, judged; the trace goes to `trace` unless that is null. It ends in the middle when
/// `stop` says so, and its verdict then counts for nothing. As StartSbc and simulate.
support::Result<simulator::Verdict> flyOne(const CampaignPlan& plan, const CampaignFlight& flight,
                                           support::Trace* trace = nullptr,
                                           const std::function<bool()>& stop = {});

/// Flies each mission once with nothing wrong and notes what is usual of it.
support::Result<void> measureMissions(CampaignPlan& plan);

struct CampaignResult {
  std::vector<std::optional<simulator::Verdict>> verdicts;  ///< by number; none: not flown
  std::optional<support::Failure> failure;  ///< of the world: the rest was not flown
  bool hung = false;                        ///< a flight did not come back
  bool interrupted = false;                 ///< flights that were under way are left
  bool running = false;  ///< a thread still runs: the program can only be ended by force
};

/// What a campaign tells while it flies; each is called by one thread at a time.
struct CampaignListener {
  /// A flight is over. A failure ends the campaign.
  std::function<support::Result<void>(const CampaignFlight&, const simulator::Verdict&)> over;
  std::function<void(uint64_t)> progress;  ///< a few times a second: how many are over
  std::function<bool()> stop;              ///< true to end it now
};

/// Flies all of which `known` has no verdict. A flight that takes longer than the plan says hangs:
/// its verdict says so and the rest is left.
CampaignResult flyAll(const CampaignPlan& plan, CampaignResult known,
                      const CampaignListener& listener);

}  // namespace glider::campaign
