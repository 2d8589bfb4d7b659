// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/output/run_trace.h"

#include "driver/output/flight_files.h"
#include "driver/output/flight_folder.h"
#include "ir/verify/value_text.h"
#include "support/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace glider::driver {
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

/// Writes all files of a trace, which then replace those of an earlier one.
support::Result<void> writeRun(const support::Trace& trace, const std::filesystem::path& place) {
  auto folder = FlightFolder::open(place, FlightFolder::Use::Run);
  if (!folder) {
    return std::unexpected(folder.error());
  }
  if (auto written = writeFlight(trace, folder->staging()); !written) {
    return written;
  }
  const auto written = support::writeFileAtomically(folder->staging() / FlightFolder::kRun,
                                                    support::traceToJson(trace));
  return written ? folder->commit() : written;
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
    trace.events.push_back({event.mission_time, event.mission_time, "transition", event.text,
                            std::string(checked.sources().text(event.range))});
  }
  trace.events.push_back(
      {run.when, run.when, "requirement", fmt::format("violated: {}", trace.scenario), run.values});
  return trace;
}

support::Result<size_t> writeRuns(const CheckedFile& checked, const std::filesystem::path& folder) {
  size_t count = 0;
  for (const ir::prove::RequirementVerdict& verdict : checked.proved.requirements) {
    if (verdict.verdict != ir::prove::Verdict::Refuted || !verdict.run) {
      continue;
    }
    const auto place = folder / fmt::format("requirement-{}", verdict.requirement + 1);
    if (auto written = writeRun(traceOfRun(*checked.compilation->checked, verdict), place);
        !written) {
      return std::unexpected(written.error());
    }
    ++count;
  }
  return count;
}

}  // namespace glider::driver
