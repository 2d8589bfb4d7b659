// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/findings/against_json.h"
#include "report/findings/findings.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace glider::report {
namespace {

using nlohmann::ordered_json;
using support::Diagnostic;
using support::Severity;
using support::SourceManager;
using support::SourceRange;

ordered_json place(const SourceManager& sources, uint32_t file, uint32_t offset) {
  const support::LineColumn at = sources.place(file, offset);
  return {{"line", at.line}, {"column", at.column}};
}

/// Adds the place of `range`; nothing for an empty range.
void addRange(ordered_json& to, const SourceManager* sources, SourceRange range) {
  if (range.valid() && sources != nullptr) {
    to["file"] = sources->name(range.file);
    to["begin"] = place(*sources, range.file, range.begin);
    to["end"] = place(*sources, range.file, std::max(range.begin, range.end));
  }
}

ordered_json diagnosticOf(const Diagnostic& diagnostic, const SourceManager* sources) {
  ordered_json one = {{"id", support::code(diagnostic.id)},
                      {"name", support::catalogueRow(diagnostic.id).slug},
                      {"severity", support::word(diagnostic.severity)}};
  addRange(one, sources, diagnostic.range);
  one["message"] = diagnostic.message;
  if (!diagnostic.hint.empty()) {
    one["hint"] = diagnostic.hint;
  }
  for (const support::DiagnosticNote& note : diagnostic.notes) {
    ordered_json told = {{"message", note.message}};
    addRange(told, sources, note.range);
    one["notes"].push_back(std::move(told));
  }
  for (const support::FixIt& fix : diagnostic.fixes) {
    ordered_json told = ordered_json::object();
    addRange(told, sources, fix.range);
    told["replacement"] = fix.replacement;
    one["fixes"].push_back(std::move(told));
  }
  return one;
}

ordered_json closedLoopOf(const FlightSearch& search) {
  ordered_json told = {{"flights", search.flights}, {"breaks", !search.scenario.empty()}};
  if (!search.scenario.empty()) {
    told["scenario"] = search.scenario;
    told["seed"] = search.seed;
    told["mission_time_s"] = search.when_s;
  }
  return told;
}

ordered_json budgetOf(const Budget& budget) {
  ordered_json told = ordered_json::object();
  for (const Quantity& quantity : budget.quantities) {
    ordered_json one = {{"value", nullptr}, {"unit", quantity.unit}, {"remark", quantity.remark}};
    if (quantity.value) {
      one["value"] = *quantity.value;
    }
    if (quantity.limit) {
      one["limit"] = *quantity.limit;
    }
    told[quantity.name] = std::move(one);
  }
  return told;
}

ordered_json missionOf(const CheckedMission& mission) {
  auto count = [&](Severity severity) {
    return std::ranges::count(mission.diagnostics, severity, &Diagnostic::severity);
  };
  ordered_json one = {{"file", mission.path},
                      {"ok", mission.ok()},
                      {"errors", count(Severity::Error)},
                      {"warnings", count(Severity::Warning)},
                      {"diagnostics", ordered_json::array()}};
  for (const Diagnostic& diagnostic : mission.diagnostics) {
    one["diagnostics"].push_back(diagnosticOf(diagnostic, mission.sources));
  }
  if (mission.failure) {
    one["failure"] = {{"id", support::code(mission.failure->id)},
                      {"message", mission.failure->message}};
    if (!mission.failure->hint.empty()) {
      one["failure"]["hint"] = mission.failure->hint;
    }
  }
  if (!mission.mission.empty()) {
    one["mission"] = mission.mission;
    one["states"] = mission.states;
    one["deepest_path"] = mission.deepest_path;
  }
  for (const Remark& remark : mission.remarks) {
    ordered_json told = {{"text", remark.text}};
    addRange(told, mission.sources, remark.range);
    one["remarks"].push_back(std::move(told));
  }
  for (const JudgedRequirement& requirement : mission.requirements) {
    ordered_json told = {{"text", requirement.text}, {"verdict", requirement.verdict}};
    addRange(told, mission.sources, requirement.range);
    if (!requirement.premise.empty()) {
      told["premise"] = requirement.premise;
    }
    if (requirement.closed_loop) {
      told["closed_loop"] = closedLoopOf(*requirement.closed_loop);
    }
    one["requirements"].push_back(std::move(told));
  }
  for (const Budget& budget : mission.budgets) {
    one["budget"][budget.of] = budgetOf(budget);
  }
  if (!mission.against.empty()) {
    one["against"] = againstJson(mission.against, *mission.sources);
  }
  return one;
}

}  // namespace

std::string findingsToJson(const std::vector<CheckedMission>& missions,
                           const std::string& version) {
  ordered_json document = {{"glidercc", version}, {"missions", ordered_json::array()}};
  for (const CheckedMission& mission : missions) {
    document["missions"].push_back(missionOf(mission));
  }
  return document.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace glider::report
