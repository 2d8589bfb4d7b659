// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/campaign.h"
#include "driver/campaign_table.h"
#include "driver/commands.h"
#include "driver/exit_code.h"
#include "driver/flight_files.h"
#include "driver/flight_setup.h"
#include "driver/launch_choice.h"
#include "driver/link_option.h"
#include "driver/sbc_choice.h"
#include "driver/scenario_choice.h"
#include "driver/share.h"
#include "driver/terminal.h"
#include "support/files.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <thread>

namespace glider::driver {
namespace {

struct CampaignOptions {
  std::vector<std::string> missions;
  std::string scenario = "default";
  uint64_t flights = 1000;
  uint64_t seed = 1;
  unsigned jobs = 0;
  std::string csv;
  std::optional<uint64_t> only;
  std::string output;
  LaunchChoice launch;
  std::vector<std::string> user_code;
};

/// Compiles and loads all missions; `status` says why there are none.
std::vector<CampaignMission> loadMissions(const CampaignOptions& options, int& status) {
  std::vector<CampaignMission> missions;
  for (const std::string& file : options.missions) {
    const auto compilation = compileForFlight(file, status);
    if (compilation == nullptr) {
      return {};
    }
    auto start = flightsInProcess(*compilation, options.launch, options.user_code, true);
    if (!start) {
      status = reportFailure(start.error());
      return {};
    }
    missions.push_back({file, std::move(*start), 0});
  }
  return missions;
}

int flyOnly(const CampaignPlan& plan, const CampaignOptions& options) {
  const CampaignFlight flight = flightOf(plan, *options.only);
  support::Trace trace;
  const auto verdict = flyOne(plan, flight, &trace);
  if (!verdict) {
    return reportFailure(verdict.error());
  }
  const simulator::Faults faults =
      simulator::drawFaults(flight.kind, flight.seed, plan.missions[flight.mission].flight_s);
  if (!options.output.empty()) {
    if (auto written = writeFlight(trace, options.output); !written) {
      return reportFailure(written.error());
    }
  }
  const bool violated = verdict->outcome == simulator::Verdict::Outcome::Violation;
  const auto printed = printOut(fmt::format(
      "flight {}: {}, {}, --seed {}\n{}{}\n", flight.number, plan.missions[flight.mission].file,
      simulator::nameOf(flight.kind), flight.seed, faultsToToml(faults),
      violated ? fmt::format("VIOLATION at {:.0f} s: {}", verdict->violation_s, verdict->violation)
      : verdict->outcome == simulator::Verdict::Outcome::Exited ? "exited"
                                                                : "handed back"));
  return !printed ? reportFailure(printed.error()) : violated ? kMissionHasErrors : kFine;
}

int flyThem(const CampaignPlan& plan, const CampaignOptions& options) {
  // Hours may pass before it is needed. What is there stays until then.
  if (!options.csv.empty() && !std::ofstream(options.csv, std::ios::app)) {
    return reportFailure(
        support::fail(support::DiagnosticId::cannotWrite, options.csv, std::strerror(errno))
            .error());
  }
  ProgressLine line;
  const auto begin = std::chrono::steady_clock::now();
  const CampaignResult result = flyAll(
      plan, [&](uint64_t over) { line.show(fmt::format("{} of {} flights", over, plan.flights)); });
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  line.clear();
  if (result.failure) {
    return reportFailure(*result.failure);
  }
  const std::string violations = violationLines(plan, result);
  const auto printed = printOut(
      campaignTable(plan, result) + violations +
      fmt::format("{} flights, seed {}, {:.1f} s\n", plan.flights, plan.seed, took.count()));
  const auto written = options.csv.empty()
                           ? support::Result<void>{}
                           : support::writeFileAtomically(options.csv, campaignCsv(plan, result));
  const int status = !printed             ? reportFailure(printed.error())
                     : !written           ? reportFailure(written.error())
                     : violations.empty() ? kFine
                                          : kMissionHasErrors;
  if (result.hung) {
    std::_Exit(status);  // its thread would not let the program end
  }
  return status;
}

int campaign(const CampaignOptions& options) {
  CampaignPlan plan;
  plan.flights = options.flights;
  plan.seed = options.seed;
  plan.jobs = options.jobs != 0 ? options.jobs : std::max(1U, std::thread::hardware_concurrency());
  auto scenario = chooseScenario(options.scenario);
  if (!scenario) {
    return reportFailure(scenario.error());
  }
  plan.scenario = std::move(*scenario);
  auto platform = platforms::loadPlatform(shareDirectory() / "platforms" / "slocum.toml");
  if (!platform) {
    return reportFailure(platform.error());
  }
  plan.platform = std::move(*platform);
  int status = kFine;
  plan.missions = loadMissions(options, status);
  if (plan.missions.empty()) {
    return status;
  }
  if (auto measured = measureMissions(plan); !measured) {
    return reportFailure(measured.error());
  }
  return options.only ? flyOnly(plan, options) : flyThem(plan, options);
}

void addOptions(CLI::App& command, CampaignOptions& options) {
  constexpr uint64_t kMostFlights = 10'000'000;
  constexpr unsigned kMostJobs = 1024;
  command.add_option("MISSION", options.missions, "The mission files; they take turns")->required();
  command
      .add_option("--scenario", options.scenario,
                  "The world to fly in: a .toml file, or the name of one that comes with glidercc")
      ->capture_default_str();
  command.add_option("--flights", options.flights, "How many flights")
      ->check(CLI::Range(uint64_t{1}, kMostFlights))
      ->capture_default_str()
      ->option_text("N");
  command.add_option("--seed", options.seed, "Seed of all faults and noise")
      ->check(seedValidator())
      ->capture_default_str()
      ->option_text("N");
  command.add_option("--jobs", options.jobs, "Flights at the same time (else: one a core)")
      ->check(CLI::Range(1U, kMostJobs))
      ->option_text("N");
  command.add_option("--csv", options.csv, "Write a row for each flight")->option_text("FILE");
  auto* only = command.add_option("--only", options.only, "Fly only the flight of this number")
                   ->check(CLI::Range(uint64_t{0}, kMostFlights - 1))
                   ->excludes("--csv")
                   ->option_text("NUMBER");
  command
      .add_option("-o", options.output,
                  "With --only: folder for report.html, trace.csv, events.csv")
      ->needs(only)
      ->option_text("FOLDER");
  addLaunchOptions(command, options.launch);
  addLinkOption(command, options.user_code);
}

}  // namespace

void addCampaignCommand(CLI::App& app, int& status) {
  auto options = std::make_shared<CampaignOptions>();
  CLI::App* command = app.add_subcommand(
      "campaign",
      "Fly missions thousands of times, each time with something that goes wrong, and "
      "tell how the flights ended");
  addOptions(*command, *options);
  command->callback([options, &status] { status = campaign(*options); });
}

}  // namespace glider::driver
