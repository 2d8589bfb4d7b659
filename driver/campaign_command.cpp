// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "campaign/campaign.h"
#include "driver/campaign/fleet_campaign.h"
#include "driver/campaign/fly.h"
#include "driver/campaign/on_ranks.h"
#include "driver/campaign/plan.h"
#include "driver/commands.h"
#include "driver/exit_code.h"
#include "driver/json_document.h"
#include "driver/shared_options.h"
#include "driver/terminal.h"
#include "driver/usage/quantity.h"
#include "driver/usage/values.h"
#include "flights/fleet/fleet_file.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>

namespace glider::driver {
namespace {

constexpr uint64_t kMostFlights = 10'000'000;

/// Flies it. `running` is set if its threads would not let the program end.
int campaign(const campaign::CampaignOptions& options, Json* document, bool& running) {
  if (options.resume.size() > 1 && options.csv.empty()) {
    throw CLI::ValidationError("--resume", "several files need `--csv FILE` for all their flights");
  }
  if (const campaign::Launch launch = campaign::launchOf(); launch.size > 1) {
    if (options.only) {
      throw CLI::ValidationError("--only", "flies one flight: start it without mpirun or srun");
    }
    if (document != nullptr) {
      throw CLI::ValidationError("--format", "json is for a campaign without mpirun or srun");
    }
    return campaignOnRanks(options, options.jobs != 0 ? options.jobs : 1, launch);
  }
  const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
  if (std::ranges::any_of(options.missions, flights::isFleetFile)) {
    if (options.missions.size() > 1) {
      throw CLI::ValidationError("MISSION", "a fleet file flies alone");
    }
    return campaignOfFleet(options, options.jobs != 0 ? options.jobs : cores, document);
  }
  campaign::CampaignPlan plan;
  if (const int status = makePlan(options, options.jobs != 0 ? options.jobs : cores, plan);
      status != kFine) {
    return status;
  }
  if (options.only) {
    return flyOnly(plan, options, document);
  }
  const auto identity = campaign::identityOf(plan, options);
  if (!identity) {
    return reportFailure(identity.error());
  }
  const Flown flown = flyThem(plan, options, *identity, nullptr, document);
  running = flown.running;
  return flown.status;
}

/// "3/100": part 3 of 100.
campaign::CampaignPart partOf(const std::string& text) {
  campaign::CampaignPart part;
  const char* const last = text.data() + text.size();
  const auto [slash, wrong] = std::from_chars(text.data(), last, part.number);
  const bool begins = wrong == std::errc() && slash != last && *slash == '/';
  const auto [end, error] = std::from_chars(begins ? slash + 1 : last, last, part.of);
  if (error != std::errc() || end != last || part.number < 1 || part.number > part.of ||
      part.of > kMostFlights) {
    throw CLI::ValidationError("--part", "`" + text + "` is not a part such as 1/8 or 8/8");
  }
  return part;
}

void addFileOptions(CLI::App& command, campaign::CampaignOptions& options) {
  auto* csv =
      command.add_option("--csv", options.csv, "Write one row per flight, as soon as it ends")
          ->option_text("FILE");
  auto* resume =
      command
          .add_option("--resume", options.resume,
                      "Resume the campaign that wrote FILE with --csv: fly the missing flights; "
                      "may be repeated with --csv, to merge parts")
          ->expected(1)
          ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
          ->option_text("FILE");
  auto* part =
      command
          .add_option_function<std::string>(
              "--part", [&options](const std::string& text) { options.part = partOf(text); },
              "Fly only part K of N, as one of N independent jobs")
          ->option_text("K/N");
  auto* only = command.add_option("--only", options.only, "Fly only the flight with this number")
                   ->check(CLI::Range(uint64_t{0}, kMostFlights - 1))
                   ->excludes(csv)
                   ->excludes(resume)
                   ->excludes(part)
                   ->option_text("NUMBER");
  command
      .add_option("-o", options.output,
                  "With --only: output folder for report.html, trace.csv and events.csv")
      ->needs(only)
      ->option_text("FOLDER");
}

void addFaultOption(CLI::App& command, campaign::CampaignOptions& options) {
  std::vector<std::string> names;
  for (const simulator::FaultKind kind : simulator::allFaultKinds()) {
    names.emplace_back(simulator::nameOf(kind));
  }
  for (uint32_t i = 0; i < campaign::kFleetFaults; ++i) {
    const char* const name = campaign::nameOf(static_cast<campaign::FleetFault>(i));
    if (std::ranges::count(names, name) == 0) {
      names.emplace_back(name);
    }
  }
  command
      .add_option("--fault", options.faults,
                  "Kind of fault to inject, as named in the table; may be repeated [all kinds]")
      ->check(oneOf(names))
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->option_text("KIND");
}

void addOptions(CLI::App& command, campaign::CampaignOptions& options) {
  constexpr unsigned kMostJobs = 1024;
  command
      .add_option(
          "MISSION", options.missions,
          "Mission files, or folders of `build --dialect extctl`, flown in turn; or one fleet file")
      ->required();
  command
      .add_option("--scenario", options.scenario,
                  "Scenario to fly in: a .toml file, or the name of a bundled one")
      ->type_name("SCENARIO")
      ->capture_default_str();
  addFlightDuration(command, options.duration_s);
  command.add_option("--flights", options.flights, "Number of flights [1000]")
      ->check(CLI::Range(uint64_t{1}, kMostFlights))
      ->capture_default_str()
      ->option_text("N");
  command.add_option("--seed", options.seed, "Seed of all faults and noise [1]")
      ->check(seedValidator())
      ->capture_default_str()
      ->option_text("N");
  command
      .add_option("--jobs", options.jobs,
                  "Number of parallel flights [one per core; under mpirun, on each rank: 1]")
      ->check(CLI::Range(1U, kMostJobs))
      ->option_text("N");
  command
      .add_option("--boards", options.board_percent,
                  "Percentage of flights that run a board's binary under an emulator [10]")
      ->check(CLI::Range(0U, 100U))
      ->capture_default_str()
      ->option_text("PERCENT");
  addFaultOption(command, options);
  command.add_flag("--strict", options.strict,
                   "Exit with 1 also for warnings, and fly nothing then");
  addFileOptions(command, options);
  addLaunchOptions(command, options.launch);
  addLinkOption(command, options.user_code);
}

}  // namespace

void addCampaignCommand(CLI::App& app, int& status) {
  auto options = std::make_shared<campaign::CampaignOptions>();
  CLI::App* command = app.add_subcommand(
      "campaign",
      "Fly missions thousands of times with injected faults and summarize the outcomes");
  addOptions(*command, *options);
  auto json = std::make_shared<bool>(false);
  addFormatOption(*command, *json);
  command->callback([options, json, &status] {
    bool running = false;
    status = inFormat(*json, "campaign",
                      [&](Json* document) { return campaign(*options, document, running); });
    if (running) {
      std::_Exit(status);  // its threads would not let the program end
    }
  });
}

}  // namespace glider::driver
