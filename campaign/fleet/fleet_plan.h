// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "campaign/fleet/fleet_trouble.h"
#include "flights/requirement_watch.h"
#include "flights/sbc_choice.h"
#include "simulator/fleet/fleet.h"
#include "support/result.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glider::campaign {

/// A vehicle of a fleet, ready to be started any number of times.
struct FleetCampaignVehicle {
  std::string name;
  uint32_t number = 0;           ///< in the fleet file: of its random numbers
  uint32_t address = 0;          ///< of its modem
  simulator::Scenario scenario;  ///< with the place where it starts
  flights::NewWatchedFlight new_flight;
  std::shared_ptr<const compiler::Optimised> compiled;  ///< what flies
  std::vector<std::string> requirements;                ///< flights::watchedTexts
  size_t assumptions_from = 0;  ///< the first of `requirements` that is an assumption
};

/// What all flights of a fleet's campaign share.
struct FleetCampaignPlan {
  simulator::Scenario world;
  std::vector<FleetCampaignVehicle> vehicles;
  std::vector<size_t> talking;                ///< those with shares, by their place in `vehicles`
  std::vector<simulator::MessageForm> forms;  ///< of their messages: they all have the same
  std::vector<FleetFault> faults;             ///< drawn in turn
  std::optional<double> separation_m;         ///< what any two must keep
  uint64_t flights = 0;
  uint64_t seed = 1;
  unsigned jobs = 1;    ///< flights at a time
  double flight_s = 0;  ///< how long the fleet flies without trouble; set by measureFleet
};

/// One flight of the campaign, defined by the plan and its number.
struct FleetCampaignFlight {
  uint64_t number = 0;
  FleetFault fault = FleetFault::None;
  uint64_t seed = 0;
};
FleetCampaignFlight flightOf(const FleetCampaignPlan& plan, uint64_t number);
/// What was drawn for it; the noise is that of the vehicles that talk.
FleetTrouble troubleOf(const FleetCampaignPlan& plan, const FleetCampaignFlight& flight);
/// The names of the vehicles that talk.
std::vector<std::string> talkersOf(const FleetCampaignPlan& plan);

/// A promise that a flight did not keep.
struct FleetViolation {
  std::string what;  ///< with the names of the vehicles
  double at_s = 0;
};

/// How a flight went.
struct FleetVerdict {
  std::vector<FleetViolation> violations;  ///< in order of time
  /// Of each vehicle, the numbers (from 0) of its requirements and assumptions that were violated.
  std::vector<std::vector<size_t>> requirements;
  bool exited = true;    ///< all missions ended and released control
  double end_s = 0;      ///< when the last of them has ended
  double deepest_m = 0;  ///< true depth
  double nearest_m = std::numeric_limits<double>::infinity();  ///< any two vehicles
  uint64_t sent = 0, received = 0, lost = 0;                   ///< messages
};

/// A flight, for its report.
struct FleetFlown {
  struct Vehicle {
    simulator::Scenario scenario;                      ///< with the noise that was drawn
    std::unique_ptr<flights::RequirementWatch> watch;  ///< null: it was not watched
  };
  simulator::FleetFlight flight;
  std::vector<Vehicle> vehicles;  ///< in the order of the plan
};

/// Flies it and checks it; the flight is written to `flown` unless that is null. It ends early when
/// `stop` returns true; its verdict is then meaningless. No message may make a vehicle break what
/// its mission promises, so a violated requirement is a violation, unless the flight breaks an
/// assumption of the same mission. Fails as StartSbc and simulateFleet do.
support::Result<FleetVerdict> flyFleet(const FleetCampaignPlan& plan,
                                       const FleetCampaignFlight& flight,
                                       std::optional<FleetFlown>* flown = nullptr,
                                       const std::function<bool()>& stop = {});

/// Flies the fleet once without trouble and records how long it takes. Returns the verdict.
support::Result<FleetVerdict> measureFleet(FleetCampaignPlan& plan);

}  // namespace glider::campaign
