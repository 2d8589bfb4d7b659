// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "flights/sbc_choice.h"
#include "simulator/campaign/draw_faults.h"
#include "simulator/campaign/judge.h"
#include "simulator/simulator.h"

#include <any>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glider::campaign {

/// A mission of a campaign, ready to be started any number of times.
struct CampaignMission {
  std::string file;
  std::string program;           ///< a digest of what is compiled from it, and of its requirements
  platforms::Platform platform;  ///< the one that it names
  simulator::VehicleSettings vehicle;  ///< the platform's, with the changes of the scenario
  std::any own;  ///< as in simulator::Scenario, of this mission's vehicle; empty: the plan's
  flights::NewFlight new_flight;
  flights::NewWatchedFlight new_watched_flight;  ///< if its requirements are checked; may be empty
  std::shared_ptr<const compiler::Optimised> compiled;  ///< what flies
  std::vector<std::string> requirements;                ///< flights::watchedTexts; of those checked
  size_t assumptions_from = 0;  ///< the first of `requirements` that is an assumption
  [[nodiscard]] bool isAssumption(size_t number) const { return number >= assumptions_from; }
  std::vector<flights::NewFlight> on_board;  ///< one for each of the plan's boards
  simulator::FlightTimes times = {};         ///< of its flight without faults
  double mean_W = 0;                         ///< of its batteries in that flight
};

/// What all flights of a campaign share.
struct CampaignPlan {
  simulator::Scenario scenario;
  std::vector<CampaignMission> missions;
  std::vector<std::string> boards;  ///< boards whose binaries fly
  unsigned board_percent = 0;       ///< of the flights; the others fly in this process
  std::vector<simulator::FaultKind> kinds = simulator::allFaultKinds();  ///< drawn in turn
  uint64_t flights = 0;
  uint64_t seed = 1;
  uint64_t part = 1, parts = 1;  ///< which share of the flights is flown; all others are left out
  unsigned jobs = 1;             ///< flights at a time, in each process
  /// A flight that takes longer, of real time, hangs. measureMissions makes them longer where
  /// flights take long.
  double hang_s = 60, hang_on_board_s = 600;
};

/// One flight of a campaign, defined by the plan and its number.
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
/// The numbers of the flights in the plan's part: from `begin` to before `end`.
struct FlightRange {
  uint64_t begin = 0, end = 0;
};
FlightRange rangeOf(const CampaignPlan& plan);
/// The faults of the flight.
simulator::DrawnFaults faultsOf(const CampaignPlan& plan, const CampaignFlight& flight);

/// Flies it and checks it; the trace is written to `trace` unless that is null. The flight ends
/// early when `stop` returns true; its verdict is then meaningless. Fails as StartSbc and simulate
/// do.
support::Result<simulator::Verdict> flyOne(const CampaignPlan& plan, const CampaignFlight& flight,
                                           support::Trace* trace = nullptr,
                                           const std::function<bool()>& stop = {});

/// Flies each mission once without faults and records its usual values.
support::Result<void> measureMissions(CampaignPlan& plan);

}  // namespace glider::campaign
