// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/check_mission.h"

#include "analysis/closed_loop.h"
#include "analysis/mission_budget.h"
#include "compiler/proof_cache.h"
#include "driver/check_progress.h"

#include <fmt/format.h>

#include <utility>

namespace glider::driver {
namespace {

using support::Result;

void tellFacts(const compiler::Compilation& compilation, report::CheckedMission& found) {
  const ir::Mission& mission = *compilation.mission;
  found.mission = mission.name;
  found.states = compiler::stateNames(mission);
  if (compilation.facts.stack_depth > 0) {
    for (const ir::StateId id : compilation.facts.deepest_path) {
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

/// `fly`: whether to look for a flight that breaks one that is refuted.
Result<report::JudgedRequirement> judgedRequirement(const compiler::Compilation& compilation,
                                                    const ir::prove::RequirementVerdict& verdict,
                                                    bool fly) {
  const auto range = compilation.mission->requirements[verdict.requirement].range;
  report::JudgedRequirement judged{range,
                                   std::string(compilation.sources.text(range)),
                                   ir::prove::word(verdict.verdict),
                                   std::nullopt,
                                   verdict.premise,
                                   verdict.cached};
  if (fly && verdict.verdict == ir::prove::Verdict::Refuted && verdict.run) {
    const auto search = analysis::searchClosedLoop(compilation, verdict);
    if (!search) {
      return std::unexpected(search.error());
    }
    judged.closed_loop = told(*search);
  }
  return judged;
}

/// Proves, and shows on a terminal how far it is.
Result<ir::prove::Findings> proveWithProgress(compiler::Compilation& compilation,
                                              const std::string& path, ir::prove::Options how) {
  CheckProgress progress(path);
  progress.at("checking cases and commands");
  how.before_requirement = [&](uint32_t number) {
    const auto& all = compilation.mission->requirements;
    progress.at(fmt::format("proving {} of {}: {}", number + 1, all.size(),
                            compilation.sources.text(all[number].range)));
  };
  return compiler::proveMission(compilation, how);
}

/// A mission that promises nothing has nothing to keep.
Result<ir::prove::Findings> proveWithCache(compiler::Compilation& compilation,
                                           const std::string& path, ir::prove::Options how,
                                           bool wanted) {
  if (!wanted || compilation.mission->requirements.empty()) {
    return proveWithProgress(compilation, path, how);
  }
  const compiler::ProofCache cache(compilation, how);
  how.cached = [&](uint32_t requirement) { return cache.find(requirement); };
  auto proved = proveWithProgress(compilation, path, how);
  if (proved) {
    cache.keep(proved->requirements);
  }
  return proved;
}

/// What goes beyond text and structure, of a mission that is ok().
Result<void> checkFurther(Checked& checked, const CheckOptions& options) {
  ir::prove::Options how;
  how.report = options.report;
  how.effort *= options.effort;
  how.run_effort *= options.effort;
  compiler::Compilation& compilation = *checked.compilation;
  auto proved = proveWithCache(compilation, checked.found.path, how, options.cache);
  if (!proved) {
    return std::unexpected(proved.error());
  }
  for (const ir::prove::ReportLine& line : proved->lines) {
    checked.found.remarks.push_back({line.range, line.text});
  }
  for (const ir::prove::RequirementVerdict& verdict : proved->requirements) {
    auto judged = judgedRequirement(compilation, verdict, options.report);
    if (!judged) {
      return std::unexpected(judged.error());
    }
    checked.found.requirements.push_back(std::move(*judged));
  }
  checked.proved = std::move(*proved);
  if (!options.report) {
    return {};
  }
  for (std::string& line :
       analysis::wayHomeLines(*compilation.mission, *compilation.platform, options.silence)) {
    checked.found.remarks.push_back({{}, std::move(line)});
  }
  auto budgets = analysis::missionBudgets(
      compilation, options.targets.empty() ? analysis::boardsInTheVehicle() : options.targets,
      options.user_code);
  if (!budgets) {
    return std::unexpected(budgets.error());
  }
  checked.found.budgets = std::move(*budgets);
  return {};
}

}  // namespace

Checked checkMission(const std::string& path, const CheckOptions& options) {
  Checked checked;
  report::CheckedMission& found = checked.found;
  found.path = path;
  auto compiled = compiler::compileMission(path);
  if (!compiled) {
    found.failure = compiled.error();
    return checked;
  }
  checked.compilation = std::move(*compiled);
  compiler::Compilation& compilation = *checked.compilation;
  found.sources = &compilation.sources;
  if (compilation.ok()) {
    if (auto done = checkFurther(checked, options); !done) {
      found.failure = done.error();
    }
  }
  found.diagnostics = compilation.diagnostics.sorted();
  if (compilation.ok()) {
    tellFacts(compilation, found);
  }
  return checked;
}

}  // namespace glider::driver
