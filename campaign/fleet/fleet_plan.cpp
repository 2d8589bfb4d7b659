// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "campaign/fleet/fleet_plan.h"

#include "campaign/seeds.h"
#include "campaign/stoppable_judge.h"
#include "flights/flight_setup.h"
#include "simulator/campaign/kinds_of_faults.h"
#include "simulator/family/family.h"
#include "vehicles/vehicle.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace glider::campaign {
namespace {

using support::Result;

/// A vehicle in one flight, with what checks it.
class Flying {
 public:
  Flying(const FleetCampaignVehicle& vehicle, const std::vector<simulator::Span>& noise,
         uint64_t seed, const std::function<bool()>& stop)
      : vehicle_(vehicle), scenario_(vehicle.scenario) {
    scenario_.seed = seed;
    scenario_.faults.modem.insert(scenario_.faults.modem.end(), noise.begin(), noise.end());
    if (flights::RequirementWatch::canWatch(*vehicle.compiled)) {
      watch_ = std::make_unique<flights::RequirementWatch>(*vehicle.compiled);
    }
    kinds_ = simulator::kindsOf(vehicle.scenario.faults);
    judge_.emplace(vehicles::vehicleOf(platform())->make_judge({platform(), scenario_, kinds_}),
                   stop);
  }
  Flying(const Flying&) = delete;
  Flying& operator=(const Flying&) = delete;

  Result<simulator::FleetMember> member();
  void judge(const support::Trace& trace, FleetVerdict& verdict) const;
  /// After that; it is of no further use then.
  FleetFlown::Vehicle release() { return {std::move(scenario_), std::move(watch_)}; }

 private:
  [[nodiscard]] const platforms::Platform& platform() const {
    return vehicle_.compiled->platform();
  }
  void judgeRequirements(const support::Trace& trace, FleetVerdict& verdict) const;

  const FleetCampaignVehicle& vehicle_;
  simulator::Scenario scenario_;
  std::unique_ptr<flights::RequirementWatch> watch_;
  std::vector<simulator::FaultKind> kinds_;
  std::optional<StoppableJudge> judge_;
};

Result<simulator::FleetMember> Flying::member() {
  simulator::StartSbc start = vehicle_.new_flight(watch_.get());
  auto sbc = start();
  if (!sbc) {
    return std::unexpected(sbc.error());
  }
  simulator::FleetMember member;
  member.number = vehicle_.number;
  member.setup.sbc = std::move(*sbc);
  member.setup.restart_sbc = std::move(start);
  member.setup.platform = platform();
  member.setup.scenario = scenario_;
  member.setup.talks = !vehicle_.compiled->mission.shares.empty();
  // A mission that waits for a message may take longer, until the vehicle's own mission ends it.
  member.setup.duration_s =
      scenario_.duration_s + simulator::familyOf(platform())->overtime_of(scenario_.own);
  member.setup.observer = &*judge_;
  flights::describeMission(member.setup, *vehicle_.compiled);
  return member;
}

void Flying::judge(const support::Trace& trace, FleetVerdict& verdict) const {
  const simulator::Verdict own = judge_->verdict();
  verdict.exited = verdict.exited && own.outcome == simulator::Verdict::Outcome::Exited;
  verdict.deepest_m = std::max(verdict.deepest_m, own.deepest_m);
  verdict.end_s = std::max(verdict.end_s, own.end_s);
  if (trace.acoustic) {
    verdict.sent += trace.acoustic->sent;
    verdict.received += trace.acoustic->received;
    verdict.lost += trace.acoustic->lost;
  }
  if (own.outcome == simulator::Verdict::Outcome::Violation) {
    verdict.violations.push_back({vehicle_.name + ": " + own.violation, own.violation_s});
  }
  verdict.requirements.emplace_back();
  if (watch_) {
    judgeRequirements(trace, verdict);
  }
}

void Flying::judgeRequirements(const support::Trace& trace, FleetVerdict& verdict) const {
  const auto found = watch_->violations(trace);
  for (const flights::FlownViolation& one : found) {
    verdict.requirements.back().push_back(one.number);
  }
  const bool assumed = std::ranges::none_of(found, [&](const flights::FlownViolation& one) {
    return one.number >= vehicle_.assumptions_from;
  });
  for (const flights::FlownViolation& one : found) {
    if (assumed) {
      verdict.violations.push_back(
          {fmt::format("{}: `{}` does not hold", vehicle_.name, vehicle_.requirements[one.number]),
           one.vehicle_time});
    }
  }
}

void judgeSeparation(const FleetCampaignPlan& plan, const simulator::Separations& separations,
                     FleetVerdict& verdict) {
  for (const simulator::PairDistance& pair : separations.pairs()) {
    verdict.nearest_m = std::min(verdict.nearest_m, pair.least_m);
    if (plan.separation_m && pair.least_m < *plan.separation_m) {
      verdict.violations.push_back(
          {fmt::format("{} and {} were {:.0f} m apart", plan.vehicles[pair.pair.one].name,
                       plan.vehicles[pair.pair.other].name, pair.least_m),
           pair.least_at_s});
    }
  }
}

/// The addresses of the other vehicles that talk.
std::vector<uint32_t> othersOf(const FleetCampaignPlan& plan, const FleetLiar& liar) {
  std::vector<uint32_t> others;
  for (size_t i = 0; i < plan.talking.size(); ++i) {
    if (i != liar.vehicle) {
      others.push_back(plan.vehicles[plan.talking[i]].address);
    }
  }
  return others;
}

simulator::AcousticTrouble acousticTrouble(const FleetCampaignPlan& plan,
                                           const FleetTrouble& trouble, uint64_t seed) {
  simulator::AcousticTrouble acoustic;
  acoustic.loss = trouble.loss;
  if (trouble.liar) {
    acoustic.liars.emplace(
        plan.vehicles[plan.talking[trouble.liar->vehicle]].number,
        simulator::Liar(trouble.liar->lie, plan.forms, othersOf(plan, *trouble.liar), seed));
  }
  return acoustic;
}

std::vector<simulator::Span> noiseOf(const FleetCampaignPlan& plan, const FleetTrouble& trouble,
                                     size_t vehicle) {
  const auto talker = std::ranges::find(plan.talking, vehicle);
  return talker == plan.talking.end()
             ? std::vector<simulator::Span>()
             : trouble.noise[static_cast<size_t>(talker - plan.talking.begin())];
}

}  // namespace

FleetCampaignFlight flightOf(const FleetCampaignPlan& plan, uint64_t number) {
  return {number, plan.faults[number % plan.faults.size()], mixed(plan.seed, number)};
}

FleetTrouble troubleOf(const FleetCampaignPlan& plan, const FleetCampaignFlight& flight) {
  return drawTrouble(flight.fault, flight.seed, plan.talking.size(), plan.flight_s);
}

std::vector<std::string> talkersOf(const FleetCampaignPlan& plan) {
  std::vector<std::string> names;
  for (const size_t talker : plan.talking) {
    names.push_back(plan.vehicles[talker].name);
  }
  return names;
}

Result<FleetVerdict> flyFleet(const FleetCampaignPlan& plan, const FleetCampaignFlight& flight,
                              std::optional<FleetFlown>* flown, const std::function<bool()>& stop) {
  const FleetTrouble trouble = troubleOf(plan, flight);
  std::vector<std::unique_ptr<Flying>> flying;
  std::vector<simulator::FleetMember> members;
  for (size_t i = 0; i < plan.vehicles.size(); ++i) {
    flying.push_back(
        std::make_unique<Flying>(plan.vehicles[i], noiseOf(plan, trouble, i), flight.seed, stop));
    auto member = flying.back()->member();
    if (!member) {
      return std::unexpected(member.error());
    }
    members.push_back(std::move(*member));
  }
  simulator::Scenario world = plan.world;
  world.seed = flight.seed;
  auto flight_of_all = simulator::simulateFleet(world, std::move(members), {},
                                                acousticTrouble(plan, trouble, flight.seed));
  if (!flight_of_all) {
    return std::unexpected(flight_of_all.error());
  }
  FleetVerdict verdict;
  const auto traces = std::make_shared<std::vector<support::Trace>>();
  for (size_t i = 0; i < flying.size(); ++i) {
    support::Trace trace = flight_of_all->take(i);
    flying[i]->judge(trace, verdict);
    if (flown != nullptr) {
      traces->push_back(std::move(trace));
    }
  }
  judgeSeparation(plan, flight_of_all->separations, verdict);
  std::ranges::stable_sort(verdict.violations, {}, &FleetViolation::at_s);
  if (flown != nullptr) {
    flight_of_all->take = [traces](size_t vehicle) { return std::move(traces->at(vehicle)); };
    flown->emplace(FleetFlown{std::move(*flight_of_all), {}});
    for (const std::unique_ptr<Flying>& vehicle : flying) {
      (*flown)->vehicles.push_back(vehicle->release());
    }
  }
  return verdict;
}

Result<FleetVerdict> measureFleet(FleetCampaignPlan& plan) {
  auto verdict = flyFleet(plan, {0, FleetFault::None, plan.world.seed});
  if (verdict) {
    plan.flight_s = verdict->end_s;
  }
  return verdict;
}

}  // namespace glider::campaign
