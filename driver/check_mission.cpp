// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/check_mission.h"

#include "analysis/analysis.h"
#include "compiler/proving.h"
#include "driver/output/check_progress.h"
#include "driver/terminal.h"
#include "flights/scenario_choice.h"
#include "ir/core/inside.h"
#include "ir/core/under_assumptions.h"
#include "slocum/mission_files/load.h"
#include "support/diagnostics/catalogue.h"
#include "support/one_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <utility>
#include <vector>

namespace glider::driver {
namespace {

using report::Remark;
using support::Result;
using Subject = Remark::Subject;

void tellFacts(const compiler::Checked& checked, report::CheckedMission& found) {
  const ir::Mission& mission = checked.mission();
  found.mission = mission.name;
  found.states = compiler::stateNames(mission);
  if (checked.facts.stack_depth > 0) {
    for (const ir::StateId id : checked.facts.deepest_path) {
      found.deepest_path.push_back(mission[id].name);
    }
  }
}

report::FlightSearch told(const analysis::ClosedLoop& search) {
  report::FlightSearch all;
  all.flights = search.flights;
  if (search.breaking) {
    all.scenario = search.breaking->scenario;
    all.seed = search.breaking->seed;
    all.when_s = search.breaking->when;
  }
  return all;
}

/// `flown`: the mission as built, to look for a flight that violates a refuted requirement; null:
/// do not look for one.
Result<report::JudgedRequirement> judgedRequirement(const compiler::Checked& checked,
                                                    const ir::prove::RequirementVerdict& verdict,
                                                    const compiler::Optimised* flown) {
  const auto range = checked.mission().requirements[verdict.requirement].range;
  report::JudgedRequirement judged{range,
                                   support::onOneLine(checked.sources().text(range)),
                                   ir::prove::word(verdict.verdict),
                                   std::nullopt,
                                   ir::prove::premisesOf(verdict, checked.mission()),
                                   verdict.reason};
  if (flown != nullptr && verdict.verdict == ir::prove::Verdict::Refuted && verdict.run) {
    const auto search = analysis::searchClosedLoop(*flown, verdict);
    if (!search) {
      return std::unexpected(search.error());
    }
    judged.closed_loop = told(*search);
  }
  return judged;
}

/// Whether a verdict is about the flight, and not about the structure of the mission alone.
bool isAboutTheFlight(ir::RequirementKind kind) {
  return kind == ir::RequirementKind::Always || kind == ir::RequirementKind::ExitWithin ||
         kind == ir::RequirementKind::SurfacesEvery;
}

/// Runs the proofs, with their progress on a terminal.
ir::prove::Findings proveWithProgress(compiler::Compilation& compilation, const std::string& path,
                                      ir::prove::Options how) {
  const compiler::Checked& checked = *compilation.checked;
  CheckProgress progress(path);
  progress.at("checking cases and commands");
  how.before_requirement = [&](uint32_t number) {
    const auto& all = checked.mission().requirements;
    progress.at(fmt::format("proving {} of {}: {}", number + 1, all.size(),
                            support::onOneLine(checked.sources().text(all[number].range))));
  };
  return compiler::prove(checked, how, compilation.diagnostics);
}

/// The vehicle's mission file, and what it says of the SBC's control.
struct Vehicle {
  analysis::VehicleFile file;
  slocum::MissionFile behaviours;  ///< its ranges are in the mission's sources
};

/// Reports what keeps hookbeh from flying the mission.
void tellDisturbances(const Vehicle& vehicle, compiler::Compilation& compilation) {
  using support::DiagnosticId;
  const compiler::Checked& checked = *compilation.checked;
  const auto platform = ir::notNarrowed(checked.platform(), checked.mission());
  const auto layers = analysis::layersOf(vehicle.behaviours, platform);
  analysis::checkGuards(checked, vehicle.file, layers, compilation.diagnostics);
  analysis::checkSameDepth(checked, vehicle.file, compilation.diagnostics);
  const analysis::MissionTimes times(checked.mission(), platform,
                                     std::max(0.0, vehicle.file.guards.start_secs));
  for (const auto& one : analysis::disturbances(vehicle.behaviours, layers, times, platform)) {
    const bool masks = one.kind == analysis::Disturbance::Kind::Masks;
    compilation.diagnostics.report(
        masks ? DiagnosticId::commandsMasked : DiagnosticId::controlPrevented, one.range, one.what,
        one.change);
  }
  for (const analysis::Doubt& one : analysis::unmetNeeds(vehicle.behaviours)) {
    compilation.diagnostics.report(DiagnosticId::sensorUnread, one.range, one.why, one.change);
  }
}

/// What the vehicle's own mission file does when the SBC has left control.
void tellWhole(const Vehicle& vehicle, bool report, CheckedFile& file) {
  compiler::Compilation& compilation = *file.compilation;
  const compiler::Checked& checked = *compilation.checked;
  const analysis::Whole whole =
      analysis::wholeOf(checked.mission(), ir::notNarrowed(checked.platform(), checked.mission()),
                        vehicle.behaviours);
  for (const analysis::Ending& ending : whole.alike()) {
    if (!ending.proved()) {
      compilation.diagnostics.report(support::DiagnosticId::mayStayBelow, ending.range,
                                     ending.after, ending.why_not, ending.change);
    }
  }
  if (report) {
    for (std::string& line : analysis::wholeLines(whole)) {
      file.found.remarks.push_back({{}, std::move(line)});
    }
  }
}

/// Puts the prover's findings into `file`. `flown`: see judgedRequirement.
Result<void> tellProved(const compiler::Optimised* flown, CheckedFile& file) {
  for (const ir::prove::ReportLine& line : file.proved.lines) {
    file.found.remarks.push_back(
        {line.range, line.text, line.about_end ? Subject::End : Subject::Other});
  }
  for (const ir::prove::RequirementVerdict& verdict : file.proved.requirements) {
    auto judged = judgedRequirement(*file.compilation->checked, verdict, flown);
    if (!judged) {
      return std::unexpected(judged.error());
    }
    const auto kind = file.compilation->checked->mission().requirements[verdict.requirement].kind;
    if (verdict.verdict == ir::prove::Verdict::Proved && isAboutTheFlight(kind)) {
      const std::string& with = file.vehicle_premise;
      judged->premise += (judged->premise.empty() || with.empty() ? "" : "; ") + with;
    }
    file.found.requirements.push_back(std::move(*judged));
  }
  return {};
}

/// The scenario that is named or, of those that come with glidercc, the usual one.
Result<simulator::Scenario> scenarioOf(const CheckOptions& options,
                                       const platforms::Platform& platform) {
  return flights::chooseScenario(options.scenario.empty() ? "default" : options.scenario, platform,
                                 reportDiagnostics);
}

/// Where the mission assumes that it starts, or else where the scenario does; empty: unknown, so
/// less is checked.
std::vector<ir::Position> startsOf(const ir::Mission& mission,
                                   const Result<simulator::Scenario>& scenario) {
  if (const auto area = ir::assumedStart(mission)) {
    return area->corners;
  }
  return scenario ? std::vector<ir::Position>{{scenario->latitude_deg, scenario->longitude_deg}}
                  : std::vector<ir::Position>();
}

/// The vehicle's mission file, if `options` name one or a scenario; reports what it does not allow,
/// and a start that the mission does not assume.
Result<std::optional<Vehicle>> checkVehicle(const CheckOptions& options,
                                            const Result<simulator::Scenario>& scenario,
                                            compiler::Compilation& compilation) {
  std::optional<analysis::VehicleFile> vehicle = options.vehicle;
  if (!options.scenario.empty()) {
    if (!scenario) {
      return std::unexpected(scenario.error());
    }
    analysis::checkStart(
        *compilation.checked,
        {"scenario `" + scenario->name + "`", {scenario->latitude_deg, scenario->longitude_deg}},
        compilation.diagnostics);
    if (!vehicle) {
      auto its = analysis::vehicleFileOf(scenario->skeleton, scenario->skeleton_path.string());
      if (!its) {
        return std::unexpected(its.error());
      }
      vehicle = std::move(*its);
    }
  }
  if (!vehicle) {
    return std::nullopt;
  }
  support::DiagnosticEngine diagnostics;  // shown when it was read first
  auto behaviours =
      slocum::loadMission(vehicle->path, *compilation.sources, diagnostics, [](auto&&...) {});
  if (!behaviours) {
    return std::unexpected(behaviours.error());
  }
  analysis::checkVehicleLimits(*compilation.checked, *vehicle, compilation.diagnostics);
  Vehicle read{std::move(*vehicle), std::move(*behaviours)};
  tellDisturbances(read, compilation);
  return read;
}

/// Flies the mission in the scenario that the options name, if nothing is wrong so far.
Result<void> tryInScenario(const CheckOptions& options, const Result<simulator::Scenario>& scenario,
                           CheckedFile& file) {
  compiler::Compilation& compilation = *file.compilation;
  if (options.scenario.empty() || compilation.diagnostics.hasErrors()) {
    return {};
  }
  simulator::Scenario world = *scenario;
  std::string hint = fmt::format("see the flight with `glidercc sim {} --scenario {}`",
                                 file.found.path, options.scenario);
  if (options.vehicle) {
    auto own = flights::loadVehiclesOwn(options.vehicle->path);
    if (!own) {
      return std::unexpected(own.error());
    }
    world.skeleton = std::move(*own);
    hint += fmt::format(", which flies with the usual mission file instead of `{}`",
                        options.vehicle->path);
  }
  return analysis::reportTrialFlight(compiler::optimise(compilation.checked), world,
                                     options.user_code, hint, compilation.diagnostics);
}

/// How the prover is asked. `starts`: where the vehicle may start.
ir::prove::Options proverOptions(const CheckOptions& options, std::vector<ir::Position> starts) {
  ir::prove::Options how;
  how.report = options.report;
  how.evidence = options.evidence;
  how.known_starts = std::move(starts);
  how.effort *= options.effort;
  how.run_effort *= options.effort;
  how.total_effort *= options.effort;
  if (options.timeout_s > 0) {
    how.until = std::chrono::steady_clock::now() +
                std::chrono::milliseconds(static_cast<int64_t>(1000 * options.timeout_s));
  }
  return how;
}

/// What --report adds on one line each. `vehicle`: its mission file, if one was named.
Result<void> tellReport(const std::optional<Vehicle>& vehicle, const ir::prove::Options& how,
                        CheckedFile& file) {
  const compiler::Checked& checked = *file.compilation->checked;
  std::vector<Remark>& remarks = file.found.remarks;
  if (const auto coverage = analysis::coverageOf(checked, file.proved.requirements, how)) {
    if (std::string line = analysis::coverageLine(*coverage, checked); !line.empty()) {
      remarks.push_back({{}, std::move(line)});
    }
  }
  if (auto line = vehicle ? analysis::endlessLine(checked, vehicle->file) : std::nullopt) {
    remarks.push_back({{}, std::move(*line), Subject::End});
  }
  const analysis::Silence silence = vehicle ? vehicle->file.silence : analysis::usualSilence();
  for (std::string& line : analysis::wayHomeLines(
           checked.mission(), ir::notNarrowed(checked.platform(), checked.mission()), silence)) {
    remarks.push_back({{}, std::move(line), Subject::WayHome});
  }
  if (!vehicle) {
    for (std::string& line : analysis::refusedLines(checked.mission(), analysis::usualLimits())) {
      remarks.push_back({{}, std::move(line)});
    }
  }
  return {};
}

/// The checks beyond text and structure, for a mission without errors.
Result<void> checkFurther(CheckedFile& file, const CheckOptions& options) {
  compiler::Compilation& compilation = *file.compilation;
  const auto scenario = scenarioOf(options, compilation.checked->platform());
  const auto vehicle = checkVehicle(options, scenario, compilation);
  if (!vehicle) {
    return std::unexpected(vehicle.error());
  }
  const ir::prove::Options how =
      proverOptions(options, startsOf(compilation.checked->mission(), scenario));
  file.proved = proveWithProgress(compilation, file.found.path, how);
  if (auto tried = tryInScenario(options, scenario, file); !tried) {
    return tried;
  }
  if (*vehicle) {
    tellWhole(**vehicle, options.report, file);
    file.vehicle_premise =
        analysis::premiseWith(*compilation.checked, (*vehicle)->file, compilation.diagnostics);
  }
  if (!options.report) {
    return tellProved(nullptr, file);
  }
  const compiler::Optimised mission = compiler::optimise(compilation.checked);
  if (auto told = tellProved(&mission, file); !told) {
    return told;
  }
  if (auto told = tellReport(*vehicle, how, file); !told) {
    return told;
  }
  auto budgets = analysis::missionBudgets(
      mission, options.targets.empty() ? analysis::boardsInTheVehicle() : options.targets,
      options.user_code, compilation.diagnostics);
  if (!budgets) {
    return std::unexpected(budgets.error());
  }
  file.found.budgets = std::move(*budgets);
  return {};
}

}  // namespace

CheckedFile checkMission(const std::string& path, const CheckOptions& options) {
  CheckedFile file;
  report::CheckedMission& found = file.found;
  found.path = path;
  auto compiled = compiler::compileMission(path);
  if (!compiled) {
    found.failure = compiled.error();
    return file;
  }
  file.compilation = std::move(*compiled);
  const compiler::Compilation& compilation = *file.compilation;
  found.sources = compilation.sources.get();
  if (compilation.checked) {
    if (auto done = checkFurther(file, options); !done) {
      found.failure = done.error();
    }
  }
  found.diagnostics = compilation.diagnostics.sorted();
  if (compilation.checked && !compilation.diagnostics.hasErrors()) {
    tellFacts(*compilation.checked, found);
  }
  return file;
}

}  // namespace glider::driver
