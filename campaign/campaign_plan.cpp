// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "campaign/campaign_plan.h"

#include "campaign/seeds.h"
#include "campaign/stoppable_judge.h"
#include "flights/shadowed_sbc.h"
#include "simulator/campaign/kinds_of_faults.h"
#include "simulator/campaign/promises.h"
#include "simulator/family/family.h"
#include "vehicles/vehicle.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <utility>

namespace glider::campaign {

using simulator::FaultKind;
using simulator::Verdict;

CampaignFlight flightOf(const CampaignPlan& plan, uint64_t number) {
  const uint64_t turn = number / plan.missions.size();
  CampaignFlight flight;
  flight.number = number;
  flight.mission = number % plan.missions.size();
  const size_t kinds = plan.kinds.size();
  flight.kind = plan.kinds[turn % kinds];
  // A different manner for each kind in each turn of the kinds.
  flight.manner =
      static_cast<simulator::Manner>((turn % kinds + turn / kinds) % simulator::kManners);
  flight.seed = mixed(plan.seed, number);
  // Independent of what the seed draws, so that the same flight in process has the same faults.
  const uint64_t choice = mixed(~plan.seed, number);
  if (!plan.boards.empty() && choice % 100 < plan.board_percent) {
    flight.board = choice / 100 % plan.boards.size();
  }
  return flight;
}

FlightRange rangeOf(const CampaignPlan& plan) {
  // No product of the two overflows: the command allows ten million flights and parts.
  return {plan.flights * (plan.part - 1) / plan.parts, plan.flights * plan.part / plan.parts};
}

simulator::DrawnFaults faultsOf(const CampaignPlan& plan, const CampaignFlight& flight) {
  return simulator::drawFaults(flight.kind, flight.manner, flight.seed,
                               plan.missions[flight.mission].times);
}

namespace {

/// What starts the SBC of a flight; on a board, `watch` watches the same mission in this process.
simulator::StartSbc startOf(const CampaignMission& mission, const CampaignFlight& flight,
                            flights::RequirementWatch* watch) {
  if (!flight.board) {
    return watch != nullptr ? mission.new_watched_flight(watch) : mission.new_flight();
  }
  simulator::StartSbc flown = mission.on_board[*flight.board]();
  return watch != nullptr
             ? flights::shadowed(std::move(flown), mission.new_watched_flight(watch), *watch)
             : flown;
}

/// An SBC that has slept acts in time, unless something else than the water and the sensors keeps
/// it from that. Control that is taken away tells that ticks did not reach it, or that their times
/// were wrong.
void judgeNaps(const std::optional<flights::LateTick>& late, std::span<const FaultKind> kinds,
               Verdict& verdict) {
  if (!late || verdict.releases > 0 || !std::ranges::all_of(kinds, simulator::leavesTheSbc)) {
    return;
  }
  simulator::Violation found{
      simulator::JudgeId::Naps, late->vehicle_time,
      fmt::format("the SBC acted {:.0f} s after the tick that made it act", late->late_s)};
  if (verdict.outcome != Verdict::Outcome::Violation || late->vehicle_time < verdict.violation_s) {
    verdict.outcome = Verdict::Outcome::Violation;
    verdict.violation = found.what;
    verdict.violation_s = found.at_s;
  }
  verdict.violations.push_back(std::move(found));
  std::ranges::stable_sort(verdict.violations, {}, &simulator::Violation::at_s);
}

}  // namespace

support::Result<Verdict> flyOne(const CampaignPlan& plan, const CampaignFlight& flight,
                                support::Trace* trace, const std::function<bool()>& stop) {
  const CampaignMission& mission = plan.missions[flight.mission];
  std::optional<flights::RequirementWatch> watch;
  if (mission.new_watched_flight) {
    watch.emplace(*mission.compiled);
  }
  simulator::StartSbc start = startOf(mission, flight, watch ? &*watch : nullptr);
  auto sbc = start();
  if (!sbc) {
    return std::unexpected(sbc.error());
  }
  const simulator::DrawnFaults drawn = faultsOf(plan, flight);
  simulator::SimulationSetup setup;
  setup.platform = mission.platform;
  setup.scenario = plan.scenario;
  setup.scenario.vehicle = mission.vehicle;
  if (mission.own.has_value()) {
    setup.scenario.own = mission.own;
  }
  drawn.applyTo(mission.platform, setup.scenario);
  setup.seed = flight.seed;
  setup.sbc = std::move(*sbc);
  setup.restart_sbc = std::move(start);
  // A mission may have to start again after the last fault.
  setup.duration_s = plan.scenario.duration_s + setup.scenario.faults.lastEnd();
  if (drawn.lasts()) {  // it may never reach its exit: then the vehicle's own mission ends it
    *setup.duration_s += simulator::familyOf(mission.platform)->overtime_of(setup.scenario.own);
  }
  std::vector<FaultKind> kinds = simulator::kindsOf(plan.scenario.faults);
  kinds.insert(kinds.end(), drawn.kinds.begin(), drawn.kinds.end());
  const std::vector<simulator::SensorFault> sensor_faults = setup.scenario.faults.sensors;
  StoppableJudge judge(vehicles::vehicleOf(mission.platform)
                           ->make_judge({mission.platform, setup.scenario, kinds, mission.mean_W}),
                       stop);
  setup.observer = &judge;
  auto flown = simulator::simulate(std::move(setup));
  if (!flown) {
    return std::unexpected(flown.error());
  }
  Verdict verdict = judge.verdict();
  if (watch) {
    judgeNaps(flights::tooLate(watch->naps(), *mission.compiled, sensor_faults), kinds, verdict);
  }
  if (watch) {
    for (const flights::FlownViolation& violation : watch->violations(*flown)) {
      verdict.requirements.push_back(violation.number);
    }
  }
  if (trace != nullptr) {
    *trace = std::move(*flown);
  }
  return verdict;
}

namespace {

/// A flight with faults may take longer than one without, on a busy machine much longer, and on an
/// emulated board longer still.
void allowTime(CampaignPlan& plan, double usual_s) {
  constexpr double kSlower = 60, kSlowerOnBoard = 1200;
  plan.hang_s = std::max(plan.hang_s, kSlower * usual_s);
  plan.hang_on_board_s = std::max(plan.hang_on_board_s, kSlowerOnBoard * usual_s);
}

}  // namespace

support::Result<void> measureMissions(CampaignPlan& plan) {
  CampaignPlan whole = plan;  // the scenario's own faults are not usual either
  whole.scenario.faults = {};
  for (size_t i = 0; i < plan.missions.size(); ++i) {
    CampaignFlight flight;
    flight.mission = i;
    flight.seed = plan.scenario.seed;
    const auto begun = std::chrono::steady_clock::now();
    const auto verdict = flyOne(whole, flight);
    if (!verdict) {
      return std::unexpected(verdict.error());
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
    allowTime(plan, took.count());
    plan.missions[i].times = {verdict->end_s, verdict->take_s, verdict->release_s,
                              verdict->deepest_m, verdict->hover};
    plan.missions[i].mean_W = verdict->mean_W;
  }
  return {};
}

}  // namespace glider::campaign
