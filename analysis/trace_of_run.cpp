// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/trace_of_run.h"

#include "ir/verify/value_text.h"

#include <fmt/format.h>

#include <limits>
#include <string>
#include <vector>

namespace glider::analysis {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr size_t kFixedColumns = 4;

std::string settingOf(const ir::Variable& parameter, double value) {
  if (parameter.type.kind == ir::TypeKind::Bool) {
    return fmt::format("{}={}", parameter.name, value != 0 ? "true" : "false");
  }
  return fmt::format("{}={}", parameter.name, ir::withUnitExactly(value, parameter.type));
}

std::vector<std::string> settingsOf(const ir::Mission& mission,
                                    const std::vector<double>& parameters) {
  std::vector<std::string> settings;
  for (const ir::Variable& variable : mission.variables) {
    if (variable.kind == ir::VariableKind::Parameter && settings.size() < parameters.size()) {
      settings.push_back(settingOf(variable, parameters[settings.size()]));
    }
  }
  return settings;
}

void addColumns(support::Trace& trace, const compiler::Checked& checked) {
  trace.columns = {{"time", "s"}, {"missiontime", "s"}, {"state", "id"}, {"true_depth", "m"}};
  for (const ir::Sensor& sensor : checked.mission().sensors) {
    const auto* known = checked.platform().find(sensor.vehicle_name);
    trace.columns.push_back(
        {sensor.vehicle_name, known == nullptr || known->unit == "1" ? "" : known->unit});
  }
}

void addRows(support::Trace& trace, const ir::prove::Counterexample& run) {
  for (const ir::prove::ConcreteTick& tick : run.ticks) {
    std::vector<double> row(trace.columns.size(), kNaN);
    row[0] = tick.mission_time;
    row[1] = tick.mission_time;
    row[2] = tick.state.index;
    row[3] = tick.depth;
    for (const ir::SensorUpdate& update : tick.frame) {
      row[kFixedColumns + update.sensor.index] = update.raw;
    }
    trace.rows.insert(trace.rows.end(), row.begin(), row.end());
  }
}

}  // namespace

support::Trace traceOfRun(const compiler::Checked& checked,
                          const ir::prove::RequirementVerdict& verdict) {
  const ir::prove::Counterexample& run = *verdict.run;
  const auto requirement = checked.mission().requirements[verdict.requirement].range;
  support::Trace trace;
  trace.mission = checked.mission().name;
  trace.scenario = std::string(checked.sources().text(requirement));
  trace.way = "proof";
  trace.requirement = verdict.requirement;
  trace.state_names = compiler::stateNames(checked.mission());
  trace.settings = settingsOf(checked.mission(), run.parameters);
  addColumns(trace, checked);
  addRows(trace, run);
  for (const auto& event : run.story) {
    trace.events.push_back(support::makeEvent(event.mission_time, support::EventId::CaseFires,
                                              {event.text},
                                              std::string(checked.sources().text(event.range))));
    trace.events.back().mission_time_s = event.mission_time;
  }
  const bool refuted = verdict.verdict == ir::prove::Verdict::Refuted;
  trace.events.push_back(support::makeEvent(
      run.when, refuted ? support::EventId::Violated : support::EventId::Satisfied,
      {trace.scenario}, run.values));
  trace.events.back().mission_time_s = run.when;
  return trace;
}

}  // namespace glider::analysis
