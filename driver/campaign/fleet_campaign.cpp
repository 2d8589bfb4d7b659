// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/campaign/fleet_campaign.h"

#include "driver/campaign/progress_text.h"
#include "driver/exit_code.h"
#include "driver/fleet/fly_fleet.h"
#include "driver/fleet/ready_vehicle.h"
#include "driver/interruption.h"
#include "driver/terminal.h"
#include "flights/fleet/message_forms.h"
#include "support/counted.h"
#include "support/diagnostics/ids/flights.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <utility>

namespace glider::driver {
namespace {

using campaign::FleetCampaignFlight;
using campaign::FleetCampaignPlan;
using campaign::FleetCampaignResult;
using campaign::FleetFault;
using campaign::FleetVerdict;
using support::Result;

std::vector<FleetFault> fleetFaultsOf(const campaign::CampaignOptions& options) {
  std::vector<FleetFault> faults;
  std::set<std::string> wrong(options.faults.begin(), options.faults.end());
  for (uint32_t i = 0; i < campaign::kFleetFaults; ++i) {
    const auto fault = static_cast<FleetFault>(i);
    if (options.faults.empty() || wrong.erase(campaign::nameOf(fault)) != 0) {
      faults.push_back(fault);
    }
  }
  if (!wrong.empty()) {
    throw CLI::ValidationError("--fault",
                               fmt::format("`{}` is of one vehicle; a fleet's are none, loss, "
                                           "silence, noise, liar and several",
                                           *wrong.begin()));
  }
  return faults;
}

/// Adds the vehicles of a fleet to a plan.
Result<void> addVehicles(const ReadyFleet& ready, FleetCampaignPlan& plan) {
  for (size_t i = 0; i < ready.vehicles.size(); ++i) {
    auto vehicle = ready.vehicles[i]->forCampaign();
    if (!vehicle) {
      return std::unexpected(vehicle.error());
    }
    const ir::Mission& mission = vehicle->compiled->mission;
    if (!mission.shares.empty()) {
      plan.talking.push_back(i);
      plan.forms = flights::messageForms(mission);
    }
    plan.vehicles.push_back(std::move(*vehicle));
  }
  return {};
}

/// GL9387 if a mission does not end without trouble.
Result<void> measureAll(const flights::Fleet& fleet, FleetCampaignPlan& plan) {
  const auto verdict = campaign::measureFleet(plan);
  if (!verdict) {
    return std::unexpected(verdict.error());
  }
  const bool ends = verdict->exited && verdict->end_s <= plan.world.duration_s;
  if (!ends && verdict->violations.empty()) {
    return support::fail(support::diagnostics::scenarioTooShort, fleet.file.string(),
                         fmt::format("{:.0f} s", plan.world.duration_s), fleet.scenario, "",
                         "fly longer than each mission lasts, with `--duration`");
  }
  return {};
}

Json violationsOf(const FleetVerdict& verdict) {
  Json violations = Json::array();
  for (const campaign::FleetViolation& one : verdict.violations) {
    violations.push_back({{"what", one.what}, {"at_s", one.at_s}});
  }
  return violations;
}

Json flightJson(const FleetCampaignFlight& flight, const FleetVerdict& verdict) {
  return {{"number", flight.number},
          {"fault", campaign::nameOf(flight.fault)},
          {"seed", flight.seed},
          {"exited", verdict.exited},
          {"deepest_m", numberOrNull(verdict.deepest_m)},
          {"nearest_m", numberOrNull(verdict.nearest_m)},
          {"sent", verdict.sent},
          {"received", verdict.received},
          {"lost", verdict.lost},
          {"violations", violationsOf(verdict)}};
}

void putFleetResult(Json& document, const FleetCampaignPlan& plan,
                    const FleetCampaignResult& result) {
  document["seed"] = plan.seed;
  document["interrupted"] = result.interrupted;
  document["flights"] = Json::array();
  campaign::eachFlown(plan, result, [&](const auto& flight, const FleetVerdict& verdict) {
    document["flights"].push_back(flightJson(flight, verdict));
  });
}

int fleetStatusOf(const FleetCampaignResult& result) {
  if (result.interrupted) {
    return kInterrupted + Interruption::signal();
  }
  const bool violated = std::ranges::any_of(
      result.verdicts, [](const auto& verdict) { return verdict && !verdict->violations.empty(); });
  return violated ? kMissionHasErrors : kFine;
}

int tellFleetResult(const FleetCampaignPlan& plan, const campaign::CampaignOptions& options,
                    const FleetCampaignResult& result, double took_s, Json* document) {
  if (result.failure) {
    return reportFailure(*result.failure);
  }
  if (document != nullptr) {
    putFleetResult(*document, plan, result);
    (*document)["took_s"] = took_s;
    return fleetStatusOf(result);
  }
  const auto flown = std::ranges::count_if(result.verdicts,
                                           [](const auto& verdict) { return verdict.has_value(); });
  const std::string all = support::counted(plan.flights, "flight");
  const std::string last =
      result.interrupted
          ? fmt::format("interrupted after {} of {}, seed {}\n", flown, all, plan.seed)
          : fmt::format("{}, seed {}, {:.1f} s\n", all, plan.seed, took_s);
  const auto printed =
      printOut(campaign::fleetTable(plan, result) + campaign::fleetRequirementLines(plan, result) +
               campaign::fleetViolationLines(plan, result, campaign::commandOf(options)) + last);
  return printed ? fleetStatusOf(result) : reportFailure(printed.error());
}

int flyAllOf(const FleetCampaignPlan& plan, const campaign::CampaignOptions& options,
             Json* document) {
  const Interruption interruption;
  ProgressLine line;
  TimeLeft left;
  const auto begin = std::chrono::steady_clock::now();
  const campaign::FleetCampaignListener listener = {
      [&](uint64_t over) { line.show(progressText(over, plan.flights, left)); },
      [] { return Interruption::signal() != 0; }};
  const FleetCampaignResult result = campaign::flyFleets(plan, listener);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  line.clear();
  return tellFleetResult(plan, options, result, took.count(), document);
}

/// Prints how one flight went, and what was drawn for it.
Result<void> tellFlight(const FleetCampaignPlan& plan, const FleetCampaignFlight& flight,
                        const FleetVerdict& verdict, Json* document) {
  const std::string drawn =
      campaign::describe(campaign::troubleOf(plan, flight), campaign::talkersOf(plan));
  if (document != nullptr) {
    (*document)["flight"] = flightJson(flight, verdict);
    (*document)["trouble"] = drawn;
    return {};
  }
  std::string text =
      fmt::format("flight {}: {}\n{}", flight.number, campaign::nameOf(flight.fault), drawn);
  for (const campaign::FleetViolation& one : verdict.violations) {
    text += fmt::format("VIOLATION at {:.0f} s: {}\n", one.at_s, one.what);
  }
  return printOut(text);
}

/// Flies one flight of the campaign, with its report in `output` if that is given.
int flyOneOf(const flights::Fleet& fleet, ReadyFleet& ready, const FleetCampaignPlan& plan,
             const FleetCampaignFlight& flight, std::optional<FleetOutput> output, Json* document) {
  std::optional<campaign::FleetFlown> flown;
  const auto begin = std::chrono::steady_clock::now();
  const auto verdict = campaign::flyFleet(plan, flight, &flown);
  if (!verdict) {
    return reportFailure(verdict.error());
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  if (auto told = tellFlight(plan, flight, *verdict, document); !told) {
    return reportFailure(told.error());
  }
  const int status = verdict->violations.empty() ? kFine : kMissionHasErrors;
  if (!output) {
    return status;
  }
  ready.seed = flight.seed;
  for (size_t i = 0; i < ready.vehicles.size(); ++i) {
    ready.vehicles[i]->hasFlown(std::move(flown->vehicles[i]));
  }
  return std::max(status,
                  reportFleet(fleet, ready, flown->flight, took.count(), *output, document));
}

/// The folder of the option `-o`; empty: it is not given.
Result<std::optional<FleetOutput>> outputOf(const campaign::CampaignOptions& options) {
  if (options.output.empty()) {
    return std::nullopt;
  }
  auto folder = FlightFolder::open(options.output);
  return folder ? Result<std::optional<FleetOutput>>(
                      FleetOutput{options.output, std::move(*folder), {}})
                : std::unexpected(folder.error());
}

/// Refuses what a campaign of a fleet does not have.
void checkFleetOptions(const campaign::CampaignOptions& options) {
  const std::pair<bool, const char*> others[] = {
      {!options.csv.empty(), "--csv"},
      {!options.resume.empty(), "--resume"},
      {options.part.of != 1, "--part"},
      {!options.launch.settings.empty(), "--set"},
      {!options.launch.file.empty(), "--parameters"},
      {!options.user_code.empty(), "--link"},
      {options.scenario != campaign::CampaignOptions().scenario, "--scenario"},
      {options.board_percent != campaign::CampaignOptions().board_percent, "--boards"}};
  for (const auto& [given, name] : others) {
    if (given) {
      throw CLI::ExcludesError("a fleet file", name);
    }
  }
}

}  // namespace

int campaignOfFleet(const campaign::CampaignOptions& options, unsigned jobs, Json* document) {
  checkFleetOptions(options);
  FleetOptions chosen;
  chosen.file = options.missions.front();
  chosen.duration_s = options.duration_s;
  const auto fleet = fleetFor(chosen);
  if (!fleet) {
    return reportFailure(fleet.error());
  }
  int status = kFine;
  auto ready = readyFleet(*fleet, "", status, options.strict);
  if (!ready) {
    return reportFailure(ready.error());
  }
  if (status != kFine) {
    return status;
  }
  FleetCampaignPlan plan;
  plan.world = ready->world;
  plan.separation_m = fleet->separation_m;
  plan.faults = fleetFaultsOf(options);
  plan.flights = options.flights;
  plan.seed = options.seed;
  plan.jobs = jobs;
  if (auto added = addVehicles(*ready, plan); !added) {
    return reportFailure(added.error());
  }
  if (plan.talking.empty()) {
    return reportFailure(support::fail(support::diagnostics::fleetCannotTalk, fleet->file.string(),
                                       "no mission shares anything, so there is nothing to disturb",
                                       "fly a campaign of each mission alone")
                             .error());
  }
  if (auto measured = measureAll(*fleet, plan); !measured) {
    const bool too_short = measured.error().id == support::diagnostics::scenarioTooShort;
    const int failed = reportFailure(measured.error());
    return too_short ? kMissionHasErrors : failed;
  }
  if (!options.only) {
    return flyAllOf(plan, options, document);
  }
  auto output = outputOf(options);
  return output ? flyOneOf(*fleet, *ready, plan, campaign::flightOf(plan, *options.only),
                           std::move(*output), document)
                : reportFailure(output.error());
}

}  // namespace glider::driver
