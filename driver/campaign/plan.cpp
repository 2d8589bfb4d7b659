// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/campaign/plan.h"

#include "codegen/digest.h"
#include "driver/compile_for_flight.h"
#include "driver/exit_code.h"
#include "driver/slocum/port_folder.h"
#include "driver/terminal.h"
#include "flights/flight_setup.h"
#include "flights/launch_choice.h"
#include "flights/sbc_choice.h"
#include "flights/scenario_choice.h"
#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/context/duration_text.h"
#include "ir/text/print.h"
#include "support/diagnostics/ids/flights.h"
#include "support/units/duration_text.h"
#include "vehicles/vehicle.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <thread>

namespace glider::driver {
namespace {

/// The vehicle of `scenario` flies the mission file of a folder for its port.
support::Result<void> useFolder(const std::string& path, const PortFolder& folder,
                                const platforms::Platform& platform,
                                simulator::Scenario& scenario) {
  auto own = flights::flyVehiclesOwn(folder.vehicle_mission, platform, scenario, reportDiagnostics);
  return own ? useChoice(path, scenario) : own;
}

/// Flights of a mission in this process; with `folder`, by the vehicle's port.
support::Result<flights::NewWatchedFlight> startsFor(const campaign::CampaignOptions& options,
                                                     const compiler::Optimised& mission,
                                                     const std::string& folder) {
  std::optional<flights::PortEnd> port;
  if (!folder.empty()) {
    const auto end = portEndOf(folder, mission);
    if (!end) {
      return std::unexpected(end.error());
    }
    port = *end;
  } else {
    const auto end = flights::usualEnd(mission.platform());
    if (!end) {
      return std::unexpected(end.error());
    }
    port = *end;
  }
  return flights::flightsInProcess(mission, options.launch, options.user_code, true, port);
}

/// Whether one of the missions is a folder for a vehicle's port.
bool hasFolder(const campaign::CampaignOptions& options) {
  return std::ranges::any_of(options.missions,
                             [](const std::string& file) { return isPortFolder(file); });
}

/// Leaves out the kinds of faults with which the vehicle of one of the missions promises nothing.
void leaveUnpromised(campaign::CampaignPlan& plan) {
  simulator::Scenario scenario = plan.scenario;
  for (const campaign::CampaignMission& mission : plan.missions) {
    const vehicles::Vehicle* const vehicle = vehicles::vehicleOf(mission.platform);
    scenario.own = mission.own.has_value() ? mission.own : plan.scenario.own;
    std::erase_if(plan.kinds, [&](simulator::FaultKind kind) {
      return vehicle != nullptr && !vehicle->promises(kind, scenario);
    });
  }
}

/// What is known of a mission before its flights.
campaign::CampaignMission missionOf(const std::string& file,
                                    const std::shared_ptr<const compiler::Optimised>& compiled,
                                    const simulator::Scenario& scenario) {
  campaign::CampaignMission mission;
  mission.file = file;
  mission.compiled = compiled;
  mission.program =
      codegen::digestOf(ir::print(compiled->mission) + ir::print(compiled->checked->mission()));
  mission.platform = compiled->platform();
  mission.vehicle = scenario.vehicle;
  mission.own = scenario.own;
  return mission;
}

/// Compiles and loads all missions into `plan`; a value other than kFine if one fails.
int loadMissions(const campaign::CampaignOptions& options, campaign::CampaignPlan& plan) {
  for (const std::string& given : options.missions) {
    int status = kFine;
    const auto folder = portFolderAt(given);
    if (!folder) {
      return reportFailure(folder.error());
    }
    const std::string file = *folder ? (*folder)->mission.string() : given;
    const std::shared_ptr<const compiler::Optimised> compiled =
        compileForFlight(file, status, options.strict);
    if (compiled == nullptr) {
      return status;
    }
    const platforms::Platform& platform = compiled->platform();
    if (auto flown = simulator::checkPlatform(platform); !flown) {
      return reportFailure(flown.error());
    }
    auto start = startsFor(options, *compiled, *folder ? given : "");
    if (!start) {
      return reportFailure(start.error());
    }
    auto scenario = flights::chooseScenario(
        options.scenario, platform,
        plan.missions.empty() ? support::ShowDiagnostics(reportDiagnostics) : nullptr);
    if (!scenario) {
      return reportFailure(scenario.error());
    }
    if (*folder) {
      if (auto own = useFolder(given, **folder, platform, *scenario); !own) {
        return reportFailure(own.error());
      }
    }
    for (const std::string& note : flights::equipFor(compiled->mission, platform, *scenario)) {
      tell(!plan.missions.empty() ? "" : "glidercc: note: " + note + "\n");
    }
    if (options.duration_s) {
      const std::string note = flights::setDuration(*scenario, platform, *options.duration_s);
      tell(note.empty() || !plan.missions.empty() ? "" : "glidercc: note: " + note + "\n");
    }
    campaign::CampaignMission mission = missionOf(file, compiled, *scenario);
    plan.scenario = std::move(*scenario);
    mission.new_flight = [flight = *start] { return flight(nullptr); };
    if (flights::RequirementWatch::canWatch(*compiled)) {
      mission.new_watched_flight = std::move(*start);
      mission.requirements = flights::watchedTexts(*compiled->checked);
      mission.assumptions_from = compiled->checked->mission().requirements.size();
    }
    for (const std::string& board : plan.boards) {
      mission.on_board.push_back(
          campaign::flightsOnBoard(compiled, options.launch, options.user_code, board));
    }
    plan.missions.push_back(std::move(mission));
  }
  return kFine;
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
        support::diagnostics::scenarioTooShort, mission.file, durationOf(plan.scenario.duration_s),
        scenario, longest ? fmt::format(": it may last {}", durationOf(*longest)) : "",
        longest
            ? fmt::format("fly longer with `--duration {}`",
                          support::durationArgument(durationFor(*longest)))
            : "fly longer than the mission lasts, with `--duration`; if it never ends, add a case "
              "with `exit`");
  }
  return {};
}

}  // namespace

int makePlan(const campaign::CampaignOptions& options, unsigned jobs,
             campaign::CampaignPlan& plan) {
  plan.flights = options.flights;
  plan.seed = options.seed;
  plan.part = options.part.number;
  plan.parts = options.part.of;
  for (const std::string& fault : options.faults) {
    const auto is = [&](simulator::FaultKind kind) { return simulator::nameOf(kind) == fault; };
    if (std::ranges::none_of(plan.kinds, is)) {
      throw CLI::ValidationError("--fault", "`" + fault + "` is of the messages of a fleet");
    }
  }
  if (!options.faults.empty()) {
    std::erase_if(plan.kinds, [&](simulator::FaultKind kind) {
      return std::ranges::find(options.faults, simulator::nameOf(kind)) == options.faults.end();
    });
  }
  plan.jobs = jobs;
  if (!hasFolder(options)) {
    chooseBoards(options, plan);
  }
  if (const int status = loadMissions(options, plan); status != kFine) {
    return status;
  }
  leaveUnpromised(plan);
  if (plan.kinds.empty()) {
    throw CLI::ValidationError("--fault", "the vehicle promises nothing about flights with it");
  }
  if (auto measured = campaign::measureMissions(plan); !measured) {
    return reportFailure(measured.error());
  }
  if (auto ends = requireEnds(plan, options.scenario); !ends) {
    reportFailure(ends.error());
    return kMissionHasErrors;
  }
  return kFine;
}

}  // namespace glider::driver
