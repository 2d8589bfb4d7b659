// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/against/against_logs.h"

#include "analysis/against/follow_mission.h"
#include "analysis/against/held_guards.h"
#include "analysis/against/log_ticks.h"
#include "ir/eval/arithmetic.h"
#include "report/picture/picture.h"
#include "support/diagnostics/ids/vehicle.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace glider::analysis {
namespace {

using report::AgainstLogs;
using report::LoggedSensor;

/// Why a sensor is never known.
std::string problemOf(const ir::Sensor& sensor, const SensorInLogs& in_logs) {
  if (!sensor.symbol.empty()) {
    return fmt::format("`{}` is a sensor of the payload computer, which is not in data files",
                       sensor.name);
  }
  if (sensor.isHeard()) {
    return fmt::format("`{}` is what other vehicles tell, which is not in data files", sensor.name);
  }
  if (!in_logs.present) {
    return fmt::format("the data files do not contain `{}`", sensor.vehicle_name);
  }
  if (in_logs.updates == 0) {
    return fmt::format("`{}` was never updated", sensor.vehicle_name);
  }
  return fmt::format("`{}` was updated {} time{}, but never in its range at a tick",
                     sensor.vehicle_name, in_logs.updates, in_logs.updates == 1 ? "" : "s");
}

/// The reading of a sensor at each tick.
void readAlong(const ir::Sensor& sensor, uint32_t number, const LogTicks& log, double to_si,
               LoggedSensor& out) {
  std::optional<ir::SensorUpdate> newest;
  double updated_s = 0;
  for (size_t tick = 0; tick < log.ticks.size(); ++tick) {
    for (const ir::SensorUpdate& update : log.ticks[tick].frame) {
      if (update.sensor.index == number) {
        newest = update;
        updated_s = log.ticks[tick].time_s;
      }
    }
    const double value =
        newest ? ir::reading(sensor, newest->raw, log.ticks[tick].time_s - updated_s) / to_si
               : ir::kUnknown;
    if (tick > 0 && ir::isKnown(value)) {
      ++out.known_ticks;
      out.least = std::fmin(out.least, value);
      out.greatest = std::fmax(out.greatest, value);
    }
  }
}

std::vector<LoggedSensor> sensorsOf(const compiler::Checked& checked, const LogTicks& log) {
  const ir::Mission& mission = checked.mission();
  std::vector<LoggedSensor> all;
  for (uint32_t i = 0; i < mission.sensors.size(); ++i) {
    const ir::Sensor& sensor = mission.sensors[i];
    const GuardRead unit = usualUnit(sensor.type);
    LoggedSensor one{.name = sensor.name,
                     .vehicle_name = sensor.vehicle_name,
                     .updates = log.sensors[i].updates,
                     .known_ticks = 0,
                     .least = ir::kUnknown,
                     .greatest = ir::kUnknown,
                     .unit = unit.unit,
                     .problem = ""};
    readAlong(sensor, i, log, unit.to_si, one);
    one.problem = one.known_ticks == 0 ? problemOf(sensor, log.sensors[i]) : "";
    all.push_back(std::move(one));
  }
  return all;
}

/// Why a guard that is never known is not.
std::vector<std::string> reasonsFor(const compiler::Checked& checked, const GuardReads& reads,
                                    const std::vector<LoggedSensor>& sensors) {
  const ir::Mission& mission = checked.mission();
  std::vector<std::string> reasons;
  for (const ir::SensorId sensor : reads.sensors) {
    if (const std::string& problem = sensors.at(sensor.index).problem; !problem.empty()) {
      reasons.push_back(problem);
    }
  }
  for (const ir::FunctionId function : reads.functions) {
    reasons.push_back(fmt::format("`{}` is a function in C", mission[function].name));
  }
  return reasons;
}

support::Trace traceOf(const compiler::Checked& checked, const LogTicks& log,
                       const Followed& followed) {
  support::Trace trace;
  trace.mission = checked.mission().name;
  trace.way = "none";
  trace.state_names = compiler::stateNames(checked.mission());
  trace.columns = {{"time", "s"}, {"m_depth", "m"}, {"state", "id"}};
  for (const report::TrackQuantity& quantity : report::pictureQuantities()) {
    trace.columns.push_back({std::string(quantity.column), ""});
  }
  for (size_t tick = 0; tick < log.ticks.size(); ++tick) {
    const LogTick& at = log.ticks[tick];
    const uint32_t state = followed.states[tick];
    trace.rows.insert(trace.rows.end(),
                      {at.time_s, at.depth_m,
                       state == Followed::kNoState ? ir::kUnknown : static_cast<double>(state)});
    trace.rows.insert(trace.rows.end(), at.quantities.begin(), at.quantities.end());
  }
  return trace;
}

void measureGaps(const LogTicks& log, AgainstLogs& out) {
  for (size_t i = 1; i < log.ticks.size(); ++i) {
    const double gap = log.ticks[i].time_s - log.ticks[i - 1].time_s;
    out.gaps += gap > report::kLongGapSeconds ? 1U : 0U;
    out.longest_gap_s = std::fmax(out.longest_gap_s, gap);
  }
}

}  // namespace

support::Result<AgainstLogs> runAgainstLogs(const compiler::Checked& checked,
                                            const std::vector<slocum::LogFile>& files,
                                            std::span<const double> parameters) {
  const ir::Mission& mission = checked.mission();
  const LogTicks log = ticksAlong(files, mission, checked.platform());
  AgainstLogs out;
  out.vehicle = files.at(0).vehicle;
  if (log.ticks.empty()) {
    return support::fail(support::diagnostics::logWithoutTimes, out.vehicle);
  }
  for (const slocum::LogFile& file : files) {
    out.files.push_back(file.path.filename().string());
  }
  out.begin = momentOf(log, 0);
  out.end = momentOf(log, static_cast<uint32_t>(log.ticks.size() - 1));
  out.ticks = static_cast<uint32_t>(log.ticks.size() - 1);
  out.science = log.science;
  measureGaps(log, out);
  out.sensors = sensorsOf(checked, log);
  for (size_t i = 0; i < parameters.size(); ++i) {
    const ir::Variable& parameter = mission.variables[i];
    const GuardRead unit = usualUnit(parameter.type);
    out.parameters.push_back({parameter.name, parameters[i] / unit.to_si, unit.unit});
  }
  for (const ir::Function& function : mission.functions) {
    out.without_code.push_back(function.name);
  }
  out.cases = evaluateGuards(checked, log, parameters);
  const std::vector<WatchedCase> watched = watchedCases(checked);
  for (size_t i = 0; i < watched.size(); ++i) {
    if (out.cases[i].known_ticks == 0) {
      out.cases[i].unknown_because = reasonsFor(checked, watched[i].reads, out.sensors);
    }
  }
  Followed followed = followMission(checked, log, parameters);
  for (size_t i = 0; i < out.cases.size(); ++i) {
    out.cases[i].followed_true_ticks = followed.true_ticks[i];
  }
  out.trace = traceOf(checked, log, followed);
  out.followed = std::move(followed.steps);
  return out;
}

}  // namespace glider::analysis
