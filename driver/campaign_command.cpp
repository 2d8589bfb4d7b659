// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "campaign/campaign.h"
#include "codegen/digest.h"
#include "driver/commands.h"
#include "driver/compile_for_flight.h"
#include "driver/exit_code.h"
#include "driver/interruption.h"
#include "driver/output/flight_files.h"
#include "driver/shared_options.h"
#include "driver/terminal.h"
#include "flights/flight_setup.h"
#include "flights/launch_choice.h"
#include "flights/sbc_choice.h"
#include "flights/scenario_choice.h"
#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/context/duration_text.h"
#include "ir/text/print.h"
#include "support/diagnostics/catalogue.h"
#include "support/files.h"
#include "support/one_line.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <thread>

namespace glider::driver {
namespace {

/// Compiles and loads all missions into `plan`; a value other than kFine if one fails.
int loadMissions(const campaign::CampaignOptions& options, campaign::CampaignPlan& plan) {
  for (const std::string& file : options.missions) {
    int status = kFine;
    const std::shared_ptr<const compiler::Optimised> compiled = compileForFlight(file, status);
    if (compiled == nullptr) {
      return status;
    }
    const platforms::Platform& platform = compiled->platform();
    if (auto flown = simulator::checkPlatform(platform); !flown) {
      return reportFailure(flown.error());
    }
    auto start = flights::flightsInProcess(*compiled, options.launch, options.user_code, true);
    if (!start) {
      return reportFailure(start.error());
    }
    auto scenario = flights::chooseScenario(
        options.scenario, platform,
        plan.missions.empty() ? support::ShowDiagnostics(reportDiagnostics) : nullptr);
    if (!scenario) {
      return reportFailure(scenario.error());
    }
    campaign::CampaignMission mission;
    mission.file = file;
    mission.compiled = compiled;
    mission.program =
        codegen::digestOf(ir::print(compiled->mission) + ir::print(compiled->checked->mission()));
    mission.platform = platform;
    mission.vehicle = scenario->vehicle;
    plan.scenario = std::move(*scenario);
    mission.new_flight = [flight = *start] { return flight(nullptr); };
    if (flights::RequirementWatch::canWatch(*compiled)) {
      mission.new_watched_flight = std::move(*start);
      mission.requirements = flights::watchedTexts(*compiled->checked);
    }
    for (const std::string& board : plan.boards) {
      mission.on_board.push_back(
          campaign::flightsOnBoard(compiled, options.launch, options.user_code, board));
    }
    plan.missions.push_back(std::move(mission));
  }
  return kFine;
}

int flyOnly(const campaign::CampaignPlan& plan, const campaign::CampaignOptions& options) {
  const campaign::CampaignFlight flight = campaign::flightOf(plan, *options.only);
  support::Trace trace;
  const auto verdict = campaign::flyOne(plan, flight, &trace);
  if (!verdict) {
    return reportFailure(verdict.error());
  }
  if (!options.output.empty()) {
    if (auto written = writeFlight(trace, options.output); !written) {
      return reportFailure(written.error());
    }
  }
  const bool violated = verdict->outcome == simulator::Verdict::Outcome::Violation;
  const auto printed = printOut(fmt::format(
      "flight {}: {}, {}, {}, {}, --seed {}\n{}{}\n", flight.number,
      plan.missions[flight.mission].file, simulator::nameOf(flight.kind),
      simulator::nameOf(flight.manner), flight.board ? plan.boards[*flight.board] : "in process",
      flight.seed, campaign::drawnToText(campaign::faultsOf(plan, flight)),
      violated ? fmt::format("VIOLATION at {:.0f} s: {}", verdict->violation_s, verdict->violation)
               : fmt::format("{}, deepest {:.1f} m", campaign::outcomeName(*verdict),
                             verdict->deepest_m)));
  return !printed ? reportFailure(printed.error()) : violated ? kMissionHasErrors : kFine;
}

/// The table of flights as it grows; without a file name nothing is written.
class FlightsFile {
 public:
  /// Begins it with `content`. GL9002.
  static support::Result<FlightsFile> begin(const std::string& name, const std::string& content) {
    FlightsFile file(name);
    if (!name.empty()) {
      file.out_.open(name, std::ios::trunc);
    }
    auto written = file.add(content);
    return written ? support::Result<FlightsFile>(std::move(file))
                   : std::unexpected(written.error());
  }
  /// Writes `text` through to the operating system, so that it is kept if this program ends in any
  /// way.
  support::Result<void> add(const std::string& text) {
    if (!name_.empty() && !(out_ << text << std::flush)) {
      return support::fail(support::DiagnosticId::cannotWrite, name_, std::strerror(errno));
    }
    return {};
  }

 private:
  explicit FlightsFile(std::string name) : name_(std::move(name)) {}
  std::string name_;
  std::ofstream out_;
};

int statusOf(const campaign::CampaignResult& result) {
  if (result.interrupted) {
    return kInterrupted + Interruption::signal();
  }
  const bool violated = std::ranges::any_of(result.verdicts, [](const auto& verdict) {
    return verdict && verdict->outcome == simulator::Verdict::Outcome::Violation;
  });
  return violated ? kMissionHasErrors : kFine;
}

/// Prints the result; sorts the file of flights by their numbers.
int tellResult(const campaign::CampaignPlan& plan, const campaign::CampaignOptions& options,
               const campaign::CampaignResult& result, const std::string& identity, double took_s) {
  if (result.failure) {
    return reportFailure(*result.failure);
  }
  const auto flown = std::ranges::count_if(result.verdicts,
                                           [](const auto& verdict) { return verdict.has_value(); });
  const std::string file = options.csv.empty() ? options.resume : options.csv;
  std::string last =
      fmt::format("{} flights, seed {}, {:.1f} s\n", plan.flights, plan.seed, took_s);
  if (result.interrupted) {
    last = fmt::format(
        "interrupted after {} of {} flights, seed {}{}\n", flown, plan.flights, plan.seed,
        file.empty()
            ? ""
            : "; to continue, give the same options and --resume " + campaign::shellWord(file));
  }
  const auto printed =
      printOut(campaign::campaignTable(plan, result) + campaign::requirementLines(plan, result) +
               campaign::violationLines(plan, result, campaign::commandOf(options)) + last);
  // A pipe already has the rows, in the order in which the flights ended.
  const auto written =
      file.empty() || !support::isReplaceable(file)
          ? support::Result<void>{}
          : support::writeFileAtomically(file, campaign::campaignCsv(plan, result, identity));
  return !printed   ? reportFailure(printed.error())
         : !written ? reportFailure(written.error())
                    : statusOf(result);
}

int flyThem(const campaign::CampaignPlan& plan, const campaign::CampaignOptions& options) {
  const auto identity = campaign::identityOf(plan, options);
  if (!identity) {
    return reportFailure(identity.error());
  }
  campaign::CampaignResult known;
  known.verdicts.resize(plan.flights);
  if (!options.resume.empty()) {
    if (auto read = campaign::readCsv(options.resume, plan, *identity, known); !read) {
      return reportFailure(read.error());
    }
  }
  auto file = FlightsFile::begin(options.csv.empty() ? options.resume : options.csv,
                                 campaign::campaignCsv(plan, known, *identity));
  if (!file) {
    return reportFailure(file.error());
  }
  const Interruption interruption;
  ProgressLine line;
  const auto begin = std::chrono::steady_clock::now();
  const campaign::CampaignListener listener = {
      [&](const campaign::CampaignFlight& flight, const simulator::Verdict& verdict) {
        return file->add(campaign::csvRow(plan, flight, verdict));
      },
      [&](uint64_t over) { line.show(fmt::format("{} of {} flights", over, plan.flights)); },
      [] { return Interruption::signal() != 0; }};
  const campaign::CampaignResult result = campaign::flyAll(plan, std::move(known), listener);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  line.clear();
  const int status = tellResult(plan, options, result, *identity, took.count());
  if (result.running) {
    std::_Exit(status);  // its threads would not let the program end
  }
  return status;
}

/// The boards whose binaries fly. Without an emulator everything flies in this process, which is
/// reported to the pilot.
void chooseBoards(const campaign::CampaignOptions& options, campaign::CampaignPlan& plan) {
  if (options.board_percent == 0) {
    return;
  }
  std::vector<std::string> missing;
  plan.boards = campaign::boardsHere(missing);
  plan.board_percent = options.board_percent;
  for (const std::string& emulator : missing) {
    tell("glidercc: warning: cannot find " + emulator + "; those flights run in this process\n");
  }
}

using ir::prove::durationOf;

/// The longest time that the mission may last without power cuts, s; none: not known.
std::optional<double> longestOf(const campaign::CampaignMission& mission) {
  if (mission.compiled == nullptr) {
    return std::nullopt;
  }
  const ir::prove::ProofContext context(mission.compiled->checked->mission(), mission.platform);
  return ir::prove::boundOf(context.withoutPowerCuts(), ir::prove::kLongestMission,
                            ir::prove::Goal::Exit)
      .by;
}

/// A time for a scenario, s: also for the time before the mission has control and after it.
double durationFor(double longest_s) {
  constexpr double kBeforeAndAfter_s = 1800;
  constexpr double kRound_s = 600;
  return kRound_s * std::ceil((longest_s + kBeforeAndAfter_s) / kRound_s);
}

/// Checks that each mission of a measured plan ends within the scenario if nothing fails: otherwise
/// every flight would count as a violation. GL9387.
support::Result<void> requireEnds(const campaign::CampaignPlan& plan, const std::string& scenario) {
  for (const campaign::CampaignMission& mission : plan.missions) {
    const double cycle = mission.platform.envelope.cycle_s;
    // A flight that ends sooner, by a fault of the scenario, is flown as it is.
    const bool cut_short = mission.times.flight_s < plan.scenario.duration_s - 2 * cycle;
    const bool ends = mission.times.take_s <= 0 || mission.times.release_s > 0;
    if (ends || cut_short) {
      continue;
    }
    const auto longest = longestOf(mission);
    return support::fail(
        support::DiagnosticId::scenarioTooShort, mission.file, durationOf(plan.scenario.duration_s),
        scenario, longest ? fmt::format(": it may last {}", durationOf(*longest)) : "",
        longest
            ? fmt::format("copy the scenario, and set `duration_s` in the copy to at least {:.0f}",
                          durationFor(*longest))
            : "copy the scenario, and set `duration_s` in the copy to longer than the mission "
              "lasts; if it never ends, add a case with `exit`");
  }
  return {};
}

int campaign(const campaign::CampaignOptions& options) {
  campaign::CampaignPlan plan;
  plan.flights = options.flights;
  plan.seed = options.seed;
  if (!options.faults.empty()) {
    std::erase_if(plan.kinds, [&](simulator::FaultKind kind) {
      return std::ranges::find(options.faults, simulator::nameOf(kind)) == options.faults.end();
    });
  }
  plan.jobs = options.jobs != 0 ? options.jobs : std::max(1U, std::thread::hardware_concurrency());
  chooseBoards(options, plan);
  if (const int status = loadMissions(options, plan); status != kFine) {
    return status;
  }
  if (auto measured = campaign::measureMissions(plan); !measured) {
    return reportFailure(measured.error());
  }
  if (auto ends = requireEnds(plan, options.scenario); !ends) {
    reportFailure(ends.error());
    return kMissionHasErrors;
  }
  return options.only ? flyOnly(plan, options) : flyThem(plan, options);
}

void addFileOptions(CLI::App& command, campaign::CampaignOptions& options) {
  constexpr uint64_t kMostFlights = 10'000'000;
  auto* csv =
      command.add_option("--csv", options.csv, "Write one row per flight, as soon as it ends")
          ->option_text("FILE");
  auto* resume =
      command
          .add_option("--resume", options.resume,
                      "Resume the campaign that wrote FILE with --csv: fly the missing flights")
          ->option_text("FILE")
          ->excludes(csv);
  auto* only = command.add_option("--only", options.only, "Fly only the flight with this number")
                   ->check(CLI::Range(uint64_t{0}, kMostFlights - 1))
                   ->excludes(csv)
                   ->excludes(resume)
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
  command
      .add_option("--fault", options.faults,
                  "Kind of fault to inject, as named in the table; may be repeated [all kinds]")
      ->check(CLI::IsMember(names))
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->option_text("KIND");
}

void addOptions(CLI::App& command, campaign::CampaignOptions& options) {
  constexpr uint64_t kMostFlights = 10'000'000;
  constexpr unsigned kMostJobs = 1024;
  command.add_option("MISSION", options.missions, "Mission files, flown in turn")->required();
  command
      .add_option("--scenario", options.scenario,
                  "Scenario to fly in: a .toml file, or the name of a bundled one")
      ->capture_default_str();
  command.add_option("--flights", options.flights, "Number of flights [1000]")
      ->check(CLI::Range(uint64_t{1}, kMostFlights))
      ->capture_default_str()
      ->option_text("N");
  command.add_option("--seed", options.seed, "Seed of all faults and noise [1]")
      ->check(seedValidator())
      ->capture_default_str()
      ->option_text("N");
  command.add_option("--jobs", options.jobs, "Number of parallel flights [one per core]")
      ->check(CLI::Range(1U, kMostJobs))
      ->option_text("N");
  command
      .add_option("--boards", options.board_percent,
                  "Percentage of flights that run a board's binary under an emulator [10]")
      ->check(CLI::Range(0U, 100U))
      ->capture_default_str()
      ->option_text("PERCENT");
  addFaultOption(command, options);
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
  command->callback([options, &status] { status = campaign(*options); });
}

}  // namespace glider::driver
