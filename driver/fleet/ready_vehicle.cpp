// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/fleet/ready_vehicle.h"

#include "driver/compile_for_flight.h"
#include "driver/exit_code.h"
#include "driver/fleet/fleet_talk.h"
#include "driver/output/flown.h"
#include "driver/terminal.h"
#include "flights/flight_setup.h"
#include "flights/launch_choice.h"
#include "flights/sbc_choice.h"
#include "flights/scenario_choice.h"
#include "support/diagnostics/ids/flights.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <utility>

namespace glider::driver {
namespace {

using support::Result;

constexpr double kHalfTurn_deg = 180;

/// `slots` of the modems of its fleet.
flights::LaunchChoice launchOf(const flights::FleetVehicle& vehicle, uint32_t slots) {
  return {vehicle.settings, "", flights::Turn{vehicle.address, slots}};
}

/// Where the vehicle starts, in the sea of the scenario.
void place(const flights::FleetVehicle& vehicle, simulator::Scenario& scenario) {
  const simulator::GeoPosition start = flights::startOf(vehicle, scenario);
  scenario.latitude_deg = start.latitude_deg;
  scenario.longitude_deg = start.longitude_deg;
  if (vehicle.heading_deg) {
    scenario.vehicle.initial_heading_rad = *vehicle.heading_deg / kHalfTurn_deg * std::numbers::pi;
  }
}

/// The scenario of the fleet as one of its vehicles has it, at the scenario's own start.
Result<simulator::Scenario> scenarioOf(const flights::Fleet& fleet,
                                       const flights::FleetVehicle& vehicle,
                                       const platforms::Platform& platform) {
  auto scenario = flights::chooseScenario(fleet.scenario, platform, reportDiagnostics);
  if (!scenario) {
    return scenario;
  }
  if (!vehicle.mi.empty()) {
    if (auto own = flights::flyVehiclesOwn(vehicle.mi, platform, *scenario, reportDiagnostics);
        !own) {
      return std::unexpected(own.error());
    }
  }
  if (fleet.duration_s) {
    (void)flights::setDuration(*scenario, platform, *fleet.duration_s);
  }
  return scenario;
}

/// Vehicles with the same mission share what is compiled.
using Missions = std::map<std::filesystem::path, std::shared_ptr<const compiler::Optimised>>;

Missions compileAll(const flights::Fleet& fleet, int& status, bool strict) {
  Missions missions;
  for (const flights::FleetVehicle& vehicle : fleet.vehicles) {
    if (!missions.contains(vehicle.mission)) {
      int its_status = kFine;
      missions[vehicle.mission] = compileForFlight(vehicle.mission.string(), its_status, strict);
      status = std::max(status, its_status);
    }
  }
  return missions;
}

std::vector<Talking> talkingOf(const flights::Fleet& fleet, const Missions& missions) {
  std::vector<Talking> talking;
  for (const flights::FleetVehicle& vehicle : fleet.vehicles) {
    const compiler::Optimised& mission = *missions.at(vehicle.mission);
    talking.push_back({&vehicle, &mission.mission, &mission.platform()});
  }
  return talking;
}

/// Refuses a name that no vehicle has.
Result<void> checkOnly(const flights::Fleet& fleet, const std::string& only) {
  std::vector<std::string> names;
  for (const flights::FleetVehicle& vehicle : fleet.vehicles) {
    names.push_back(vehicle.name);
  }
  if (only.empty() || std::ranges::find(names, only) != names.end()) {
    return {};
  }
  return support::fail(support::diagnostics::noSuchVehicle, fleet.file.string(), only,
                       fmt::to_string(fmt::join(names, ", ")));
}

}  // namespace

ReadyVehicle::ReadyVehicle(const flights::FleetVehicle& vehicle, uint32_t number, uint32_t slots,
                           std::shared_ptr<const compiler::Optimised> mission,
                           simulator::Scenario scenario)
    : vehicle_(vehicle),
      number_(number),
      slots_(slots),
      mission_(std::move(mission)),
      scenario_(std::move(scenario)) {
  if (flights::RequirementWatch::canWatch(*mission_)) {
    watch_ = std::make_unique<flights::RequirementWatch>(*mission_);
  }
}

std::string ReadyVehicle::missionFile() const {
  return vehicle_.mission.filename().string();
}

std::string ReadyVehicle::platformName() const {
  return mission_->platform().name;
}

Result<simulator::FleetMember> ReadyVehicle::member() {
  const auto port = flights::usualEnd(mission_->platform());
  if (!port) {
    return std::unexpected(port.error());
  }
  auto start = flights::sbcInProcess(*mission_, launchOf(vehicle_, slots_), vehicle_.user_code,
                                     !scenario_.faults.empty(), watch_.get(), *port);
  if (!start) {
    return std::unexpected(flights::ofVehicle(vehicle_, start.error()));
  }
  auto sbc = (*start)();
  if (!sbc) {
    return std::unexpected(sbc.error());
  }
  simulator::FleetMember member;
  member.number = number_;
  member.setup.sbc = std::move(*sbc);
  member.setup.restart_sbc = std::move(*start);
  member.setup.platform = mission_->platform();
  member.setup.scenario = scenario_;
  member.setup.talks = !mission_->mission.shares.empty();
  member.setup.spools = true;  // a fleet may fly for weeks
  flights::describeMission(member.setup, *mission_);
  return member;
}

Result<campaign::FleetCampaignVehicle> ReadyVehicle::forCampaign() const {
  const auto port = flights::usualEnd(mission_->platform());
  if (!port) {
    return std::unexpected(port.error());
  }
  auto start = flights::flightsInProcess(*mission_, launchOf(vehicle_, slots_), vehicle_.user_code,
                                         true, *port);
  if (!start) {
    return std::unexpected(flights::ofVehicle(vehicle_, start.error()));
  }
  campaign::FleetCampaignVehicle flown;
  flown.name = vehicle_.name;
  flown.number = number_;
  flown.address = vehicle_.address;
  flown.scenario = scenario_;
  flown.new_flight = std::move(*start);
  flown.compiled = mission_;
  if (watch_) {
    flown.requirements = flights::watchedTexts(*mission_->checked);
    flown.assumptions_from = mission_->checked->mission().requirements.size();
  }
  return flown;
}

void ReadyVehicle::hasFlown(campaign::FleetFlown::Vehicle flown) {
  scenario_ = std::move(flown.scenario);
  watch_ = std::move(flown.watch);
}

std::vector<support::Diagnostic> ReadyVehicle::judge(support::Trace& trace) const {
  const Flown flown{mission_.get(), watch_.get(), ""};
  const auto outcome = watch_ ? watch_->outcome(trace) : flights::FlownOutcome();
  addFacts(flown, launchOf(vehicle_, slots_), outcome, trace);
  return driver::judge(trace, flown, outcome.violations, scenario_);
}

Result<ReadyFleet> readyFleet(const flights::Fleet& fleet, const std::string& only, int& status,
                              bool strict) {
  if (auto known = checkOnly(fleet, only); !known) {
    return std::unexpected(known.error());
  }
  const Missions missions = compileAll(fleet, status, strict);
  if (status == kFine) {
    if (auto talk = checkTalk(fleet, talkingOf(fleet, missions)); !talk) {
      return std::unexpected(talk.error());
    }
  }
  ReadyFleet ready;
  for (uint32_t number = 0; status == kFine && number < fleet.vehicles.size(); ++number) {
    const flights::FleetVehicle& vehicle = fleet.vehicles[number];
    const auto& mission = missions.at(vehicle.mission);
    auto scenario = scenarioOf(fleet, vehicle, mission->platform());
    if (!scenario) {
      return std::unexpected(scenario.error());
    }
    (void)flights::equipFor(mission->mission, mission->platform(), *scenario);
    if (number == 0) {
      ready.world = *scenario;
      ready.seed = fleet.seed.value_or(scenario->seed);
      ready.world.seed = ready.seed;
    }
    scenario->seed = ready.seed;
    place(vehicle, *scenario);
    if (only.empty() || vehicle.name == only) {
      ready.vehicles.push_back(std::make_unique<ReadyVehicle>(
          vehicle, number, flights::slotsOf(fleet), mission, std::move(*scenario)));
    }
  }
  return ready;
}

}  // namespace glider::driver
