// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "compiler/compilation.h"
#include "compiler/share.h"
#include "compiler/vehicles.h"
#include "driver/commands.h"
#include "driver/compile_for_flight.h"
#include "driver/exit_code.h"
#include "driver/fleet/fly_fleet.h"
#include "driver/json_document.h"
#include "driver/output/flight_files.h"
#include "driver/output/flight_folder.h"
#include "driver/output/flown.h"
#include "driver/output/overwritten.h"
#include "driver/output/time_left.h"
#include "driver/output/track_colour.h"
#include "driver/replay_trace.h"
#include "driver/shared_options.h"
#include "driver/sim_options.h"
#include "driver/slocum/port_folder.h"
#include "driver/slocum/science_program.h"
#include "driver/terminal.h"
#include "driver/usage/quantity.h"
#include "flights/fleet/fleet_file.h"
#include "flights/flight_setup.h"
#include "flights/scenario_choice.h"
#include "report/export/export.h"
#include "report/picture/picture.h"
#include "report/summary.h"
#include "report/text.h"
#include "report/warnings.h"
#include "simulator/simulator.h"
#include "support/diagnostics/ids/command.h"
#include "support/diagnostics/ids/files.h"
#include "support/files.h"
#include "support/trace/trace.h"
#include "vehicles/vehicle.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <system_error>

namespace glider::driver {
namespace {

/// "1:23:20 of at most 6:00:00, depth 12.3 m, state survey, about 8 min left".
std::string progressText(const simulator::Progress& progress, TimeLeft& left) {
  const std::string estimate =
      left.of(static_cast<uint64_t>(progress.time_s), static_cast<uint64_t>(progress.duration_s));
  return fmt::format("{} of at most {}, depth {:.1f} m{}{}{}{}", report::clockText(progress.time_s),
                     report::clockText(progress.duration_s), progress.depth_m,
                     progress.state.empty() ? "" : ", state ", progress.state,
                     estimate.empty() ? "" : ", ", estimate);
}

void showProgress(simulator::SimulationSetup& setup, ProgressLine& line) {
  setup.progress = [&line, left = TimeLeft()](const simulator::Progress& progress) mutable {
    line.show(progressText(progress, left));
  };
}

/// Writes the flight in the formats of other programs.
support::Result<void> writeForOthers(const support::Trace& trace, const SimOptions& options,
                                     const FlightFolder& folder) {
  if (!options.kml.empty()) {
    const std::string text = report::flightToKml(trace);
    if (auto written = support::writeFileAtomically(folder.placeOf(options.kml), text); !written) {
      return written;
    }
  }
  if (!options.geojson.empty()) {
    const std::string text = report::flightToGeojson(trace);
    if (auto written = support::writeFileAtomically(folder.placeOf(options.geojson), text);
        !written) {
      return written;
    }
  }
  return options.netcdf.empty() ? support::Result<void>()
                                : report::writeFlightNetcdf(trace, folder.placeOf(options.netcdf));
}

/// Writes all files of a flight to where the options say.
support::Result<void> writeAll(const support::Trace& trace, const SimOptions& options,
                               const std::vector<support::Diagnostic>& reported,
                               FlightFolder& folder, Json* document) {
  if (auto written = writeFlight(trace, folder.staging(), reported); !written) {
    return written;
  }
  if (!options.picture.empty()) {
    const std::string drawn = report::drawPicture(trace, styleFor(trace, options.picture_style));
    if (auto written = support::writeFileAtomically(folder.placeOf(options.picture), drawn);
        !written) {
      return written;
    }
  }
  if (document != nullptr) {
    document->update(Json::parse(flightToJson(trace, reported, folder.names())));
  }
  if (auto written = writeForOthers(trace, options, folder); !written) {
    return written;
  }
  if (auto written = writeFlightSummary(trace, reported, folder.names(), folder.staging());
      !written) {
    return written;
  }
  return folder.commit();
}

/// Flies and writes; the flight has been set up.
int flyAndReport(simulator::SimulationSetup setup, const SimOptions& options, const Flown& flown,
                 FlightFolder& folder, Json* document) {
  const simulator::Scenario scenario = setup.scenario;
  ProgressLine line;
  showProgress(setup, line);
  const auto begin = std::chrono::steady_clock::now();
  auto trace = simulator::simulate(std::move(setup));
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  line.clear();
  if (!trace) {
    return reportFailure(trace.error());
  }
  const auto outcome =
      flown.watch != nullptr ? flown.watch->outcome(*trace) : flights::FlownOutcome();
  addFacts(flown, options.launch, outcome, *trace);
  const double end = trace->rowCount() == 0 ? 0 : trace->at(trace->rowCount() - 1, 0);
  const auto printed =
      document != nullptr
          ? support::Result<void>{}
          : printSuccess(
                report::summarize(*trace) +
                fmt::format(
                    "\nflown {:.0f} s in {:.4f} s; report: {}\n", end, took.count(),
                    (std::filesystem::path(outputFolder(options)) / "report.html").string()));
  const auto reported = judge(*trace, flown, outcome.violations, scenario);
  if (auto written = writeAll(*trace, options, reported, folder, document); !written) {
    return reportFailure(written.error());
  }
  if (document != nullptr) {
    (*document)["flown_s"] = end;
    (*document)["folder"] = outputFolder(options);
  }
  if (!printed) {
    return reportFailure(printed.error());
  }
  const bool foreign = !options.program.empty() || !options.serial.empty();
  if (foreign && !report::spokeTheProtocol(*trace)) {
    return kWorldFailed;  // the program to be the SBC cannot be used
  }
  return reported.empty() ? kFine : kMissionHasErrors;
}

/// What watches the flight; empty for a real SBC, or for a mission without requirements.
std::optional<flights::RequirementWatch> watchOf(const SimOptions& options,
                                                 const compiler::Optimised* mission) {
  const bool can =
      mission != nullptr && options.serial.empty() && flights::RequirementWatch::canWatch(*mission);
  return can ? std::optional<flights::RequirementWatch>(*mission) : std::nullopt;
}

/// Unless there is nothing to say.
void tellNote(const std::string& note) {
  tell(note.empty() ? "" : "glidercc: note: " + note + "\n");
}

/// The scenario with the duration and the mission of the vehicle's own that the options name.
support::Result<simulator::Scenario> scenarioFor(const SimOptions& options,
                                                 const platforms::Platform& platform) {
  auto scenario = flights::chooseScenario(options.scenario, platform, reportDiagnostics);
  if (!scenario) {
    return scenario;
  }
  const std::string& own_file = isVehiclesOwn(options) ? options.mission : options.mi;
  if (!own_file.empty()) {
    auto own = flights::flyVehiclesOwn(own_file, platform, *scenario, reportDiagnostics);
    if (!own) {
      return std::unexpected(own.error());
    }
    if (!options.port_folder.empty()) {
      if (auto used = useChoice(options.port_folder, *scenario); !used) {
        return std::unexpected(used.error());
      }
    } else if (!options.mi
                    .empty()) {  // a mission needs hookbeh in it; other errors were shown above
      if (auto usable = vehicles::tryInFlight(options.mi); !usable) {
        return std::unexpected(usable.error());
      }
    }
  }
  if (options.science) {
    if (auto used = useScienceProgram(*options.science, platform, *scenario); !used) {
      return std::unexpected(used.error());
    }
  }
  if (options.duration_s) {
    tellNote(flights::setDuration(*scenario, platform, *options.duration_s));
  }
  return scenario;
}

/// Refuses outputs that would overwrite an input or each other.
support::Result<void> checkOutputs(const SimOptions& options) {
  const std::vector<std::string> outputs = {options.picture, options.kml, options.geojson,
                                            options.netcdf};
  if (const auto input = overwrittenInput(
          {options.mission, options.scenario, options.mi, options.launch.file}, outputs)) {
    return support::fail(support::diagnostics::outputIsInput, *input);
  }
  std::set<std::filesystem::path> seen;
  for (const std::string& output : outputs) {
    std::error_code error;  // reported when the file is written
    const std::filesystem::path absolute = std::filesystem::absolute(output, error);
    const std::filesystem::path real =
        error ? std::filesystem::path() : std::filesystem::weakly_canonical(absolute, error);
    if (!output.empty() && !error && !seen.insert(real).second) {
      return support::fail(support::diagnostics::cannotWrite, output, "two outputs have this name");
    }
  }
  return {};
}

/// What to type for the binary that chooseSbc has built into `folder`.
std::string waitingForDebugger(const SimOptions& options, const std::filesystem::path& folder) {
  const std::string binary = flightName(options) + "-" + options.board;
  return fmt::format(
      "glidercc: note: the mission waits for a debugger; in another terminal:\n"
      "  gdb-multiarch -x {} -ex 'target remote :{}' {}\n",
      (compiler::shareDirectory() / "debugger" / "glider.gdb").string(), *options.debugger,
      std::filesystem::absolute(folder / (binary + ".debug")).string());
}

int sim(const SimOptions& options, Json* document) {
  if (!options.replay.empty()) {
    return replayTrace(options);
  }
  if (const auto checked = checkOutputs(options); !checked) {
    return reportFailure(checked.error());
  }
  int status = kFine;
  const std::shared_ptr<const compiler::Optimised> mission =
      options.mission.empty() || isVehiclesOwn(options) ? nullptr
                                                        : compileForFlight(options.mission, status);
  if (status != kFine) {
    return status;
  }
  const auto platform = mission != nullptr
                            ? support::Result<platforms::Platform>(mission->platform())
                            : compiler::loadVehicle(options.platform);
  if (!platform) {
    return reportFailure(platform.error());
  }
  auto scenario = scenarioFor(options, *platform);
  if (!scenario) {
    return reportFailure(scenario.error());
  }
  if (mission != nullptr) {
    std::ranges::for_each(flights::equipFor(mission->mission, *platform, *scenario), tellNote);
  }
  auto folder = FlightFolder::open(outputFolder(options));
  if (!folder) {
    return reportFailure(folder.error());
  }
  std::optional<flights::RequirementWatch> watch = watchOf(options, mission.get());
  auto start = chooseSbc(options, mission.get(), !scenario->faults.empty(), folder->staging(),
                         watch ? &*watch : nullptr);
  if (!start) {
    return reportFailure(start.error());
  }
  tell(options.debugger ? waitingForDebugger(options, folder->staging()) : "");
  simulator::SimulationSetup setup;
  if (*start) {
    auto sbc = (*start)();
    if (!sbc) {
      return reportFailure(sbc.error());
    }
    setup.sbc = std::move(*sbc);
    setup.restart_sbc = std::move(*start);
  }
  setup.platform = *platform;
  setup.scenario = std::move(*scenario);
  setup.seed = options.seed;
  setup.kill_sbc_at_s = options.kill_sbc_at_s;
  if (mission != nullptr) {
    flights::describeMission(setup, *mission);
  } else if (isVehiclesOwn(options)) {
    setup.mission_name = std::filesystem::path(options.mission).filename().string();
  }
  return flyAndReport(std::move(setup), options,
                      {mission.get(), watch ? &*watch : nullptr, options.port_folder}, *folder,
                      document);
}

void addFlightOptions(CLI::App& command, SimOptions& options) {
  command.add_option("--seed", options.seed, "Seed of all noise [the scenario's]")
      ->check(seedValidator())
      ->option_text("N");
  addDurationOption(command, "--kill-sbc-at", options.kill_sbc_at_s, 0, simulator::kLongestFlight_s,
                    "Cut the SBC's power at this vehicle time, as in 600s or 10min");
  addFlightDuration(command, options.duration_s);
}

/// The picture, and the formats of other programs.
void addExportOptions(CLI::App& command, SimOptions& options) {
  CLI::Option* const picture = addPictureOptions(command, options.picture, options.picture_style);
  picture->excludes("--replay");
  command.add_option("--chart", options.chart, "What the picture of a fleet shows [depths]")
      ->check(oneOf(fleetCharts()))
      ->option_text("CHART")
      ->needs(picture);
  command
      .add_option("--kml", options.kml,
                  "Write the tracks, surfacings and waypoints of the flight as KML")
      ->option_text("OUT.kml")
      ->excludes("--replay");
  command
      .add_option("--geojson", options.geojson,
                  "Write the tracks, surfacings and waypoints of the flight as GeoJSON")
      ->option_text("OUT.geojson")
      ->excludes("--replay");
  command
      .add_option("--netcdf", options.netcdf,
                  "Write the trace of the flight as netCDF-4 by the CF conventions")
      ->option_text("OUT.nc")
      ->excludes("--replay");
}

/// The sea, and the mission file of the vehicle.
void addWorldOptions(CLI::App& command, SimOptions& options) {
  command
      .add_option("--scenario", options.scenario,
                  "Scenario to fly in: a .toml file, or the name of a bundled one")
      ->type_name("SCENARIO")
      ->capture_default_str();
  command
      .add_option(
          "--mi", options.mi,
          "The vehicle's mission file (.mi) with hookbeh, as in `check --mi` [the scenario's]")
      ->option_text("FILE.mi");
}

CLI::Option* addScienceOption(CLI::App& command, SimOptions& options) {
  return command
      .add_option("--science", options.science,
                  "Run this program as the vehicle's science computer: hookprog as built from the "
                  "kit for integrators, here or under an emulator")
      ->option_text("COMMAND");
}

CLI::Option* addBoardOptions(CLI::App& command, SimOptions& options) {
  auto* board = command
                    .add_option("--board", options.board,
                                "Run the binary for this target, as listed by `glidercc targets`, "
                                "behind a serial line [run the mission inside glidercc]")
                    ->type_name("TARGET");
  command
      .add_option("--debugger", options.debugger,
                  "With --board: let the binary wait for gdb on this TCP port, as in 2345")
      ->option_text("PORT")
      ->check(CLI::Range(1, 65535))
      ->needs(board);
  return board;
}

void addOptions(CLI::App& command, SimOptions& options) {
  auto* mission =
      command.add_option("MISSION", options.mission,
                         "The mission file, a mission of the vehicle's own (FILE.mi), which flies "
                         "without an SBC, a folder of `build --dialect extctl`, or a fleet "
                         "(FLEET.toml): several vehicles in one sea");
  addWorldOptions(command, options);
  CLI::Option* board = addBoardOptions(command, options);
  auto* program =
      command
          .add_option("--sbc", options.program,
                      "Run this program as the SBC; MISSION then only provides the names of its "
                      "states and the requirements")
          ->option_text("PROGRAM");
  auto* serial = command
                     .add_option("--serial", options.serial,
                                 "Use a real SBC on this serial device, in real time; MISSION then "
                                 "only provides the names of its states")
                     ->option_text("DEVICE");
  command
      .add_flag("--lockstep", options.lockstep,
                "With --serial: wait for each answer instead of running in real time")
      ->needs(serial);
  auto* science = addScienceOption(command, options)->excludes(serial);
  auto* without = command.add_flag("--no-sbc", options.without_sbc, "Fly without an SBC");
  command
      .add_option("--platform", options.platform,
                  "Vehicle to fly without a MISSION; a mission names its own")
      ->capture_default_str()
      ->option_text("NAME")
      ->excludes(mission);
  addFlightOptions(command, options);
  command
      .add_option("-o", options.output,
                  "Output folder for report.html, trace.csv, events.csv and flight.json "
                  "[MISSION-flight in the current folder]")
      ->option_text("FOLDER");
  command
      .add_option("--replay", options.replay,
                  "Fly a counterexample written by `glidercc check --traces`, as in "
                  "DIR/requirement-1, instead of a scenario")
      ->option_text("TRACE")
      ->excludes("--scenario")
      ->excludes("--mi")
      ->excludes("--seed")
      ->excludes("--kill-sbc-at")
      ->excludes("--duration")
      ->needs(mission);
  command.add_option("--only", options.only, "Of a fleet: fly this vehicle alone")
      ->option_text("NAME");
  addExportOptions(command, options);
  program->excludes(board);
  serial->excludes(board)->excludes(program)->excludes("--replay");
  science->excludes("--replay");
  without->excludes(mission)->excludes(board)->excludes(program)->excludes(serial);
}

}  // namespace

namespace {

/// Refuses what a fleet file says for each of its vehicles, and what only one vehicle can have.
void checkFleetOptions(const CLI::App& command) {
  constexpr std::array<std::string_view, 10> kOfFleets = {
      "--picture",  "--chart", "MISSION",  "--only",  "--seed",
      "--duration", "-o",      "--format", "--quiet", "--color"};
  for (const CLI::Option* option : command.get_options()) {
    const auto is = [&](std::string_view name) {
      return option->check_name(std::string(name)) || option->get_name() == name;
    };
    if (option->count() > 0 && std::ranges::none_of(kOfFleets, is)) {
      throw CLI::ExcludesError("a fleet file", option->get_name());
    }
  }
}

/// If MISSION is a folder for a vehicle's port, what is in it is flown.
support::Result<void> lookIntoFolder(SimOptions& options) {
  const auto folder = portFolderAt(options.mission);
  if (!folder) {
    return std::unexpected(folder.error());
  }
  if (!*folder) {
    return {};
  }
  options.port_folder = options.mission;
  options.mission = (*folder)->mission.string();
  options.mi = (*folder)->vehicle_mission.string();
  return {};
}

}  // namespace

void addSimCommand(CLI::App& app, int& status) {
  auto options = std::make_shared<SimOptions>();
  CLI::App* command =
      app.add_subcommand("sim", "Fly a mission in the simulator and write a report");
  addOptions(*command, *options);
  addLaunchOptions(*command, options->launch);
  addLinkOption(*command, options->user_code);
  addFormatOption(*command, options->json);
  command->get_option("--format")->excludes("--replay");
  command->callback([options, command, &status] {
    if (options->mission.empty() && options->program.empty() && options->serial.empty() &&
        !options->without_sbc) {
      throw CLI::RequiredError("MISSION (or --sbc PROGRAM, --serial DEVICE, or --no-sbc)");
    }
    if (flights::isFleetFile(options->mission)) {
      checkFleetOptions(*command);
      const FleetOptions fleet{options->mission, options->only,
                               options->output,  {options->picture, options->chart},
                               options->seed,    options->duration_s};
      status =
          inFormat(options->json, "sim", [&](Json* document) { return flyFleet(fleet, document); });
      return;
    }
    for (const char* option : {"--only", "--chart"}) {
      if (command->count(option) != 0) {
        throw CLI::RequiredError(std::string(option) + " needs a fleet file as MISSION");
      }
    }
    if (isVehiclesOwn(*options) && !options->mi.empty()) {
      throw CLI::ExcludesError("MISSION of the vehicle's own", "--mi");
    }
    if (const auto looked = lookIntoFolder(*options); !looked) {
      status = reportFailure(looked.error());
      return;
    }
    status =
        inFormat(options->json, "sim", [&](Json* document) { return sim(*options, document); });
  });
}

}  // namespace glider::driver
