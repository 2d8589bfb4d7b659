// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/replay.h"

#include "ir/eval/interpreter.h"
#include "ir/prove/context/proof_context.h"
#include "ir/prove/context/requirement_monitor.h"
#include "ir/worlds/depth_sensor.h"
#include "simulator/replay/replay.h"
#include "support/counted.h"
#include "support/diagnostics/ids/flights.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace glider::analysis {
namespace {

using support::Result;

/// Columns of the trace that hold what the mission's sensors report.
std::vector<int> sensorColumns(const support::Trace& trace, const ir::Mission& mission) {
  std::vector<int> columns;
  for (const ir::Sensor& sensor : mission.sensors) {
    columns.push_back(trace.column(sensor.vehicle_name));
  }
  return columns;
}

/// Feeds the rows of a counterexample to a real SBC as frames of a vehicle that accepts every
/// instruction, and to the interpreter. The first tick at which state, call depth or exit differ
/// ends the replay: then the compiled mission or the interpreter is wrong.
class Replay {
 public:
  Replay(const support::Trace& trace, const compiler::Checked& checked,
         const std::vector<std::string>& built_states)
      : trace_(trace),
        built_states_(built_states),
        m_(checked.mission()),
        platform_(checked.platform()),
        columns_(sensorColumns(trace, m_)),
        depth_(trace.column("true_depth")),
        interpreter_(m_, checked.facts.stack_depth),
        monitor_(m_, m_.requirements[*trace.requirement], checked.platform().world.surface_depth_m,
                 ir::depthSensor(m_, checked.platform())) {}

  Result<Replayed> run(simulator::SbcPort& sbc, const std::vector<double>& parameters) {
    std::vector<simulator::ReplayTick> ticks;
    for (size_t row = 0; row < trace_.rowCount(); ++row) {
      ticks.push_back(tickOf(row));
    }
    const auto answers = simulator::replay(platform_, sbc, ticks);
    if (answers.empty()) {
      return differs("it never asks for control");
    }
    for (size_t row = 0; row < trace_.rowCount(); ++row) {
      const ir::TickResult expected = step(row, parameters);
      if (row >= answers.size()) {
        return differs("it ends after " + support::counted(answers.size(), "tick"));
      }
      if (auto same = compare(answers[row], expected, time(row)); !same) {
        return std::unexpected(same.error());
      }
      ++result_.ticks;
      if (expected.finished) {
        break;
      }
    }
    result_.broken = monitor_.when().has_value();
    result_.when = monitor_.when().value_or(0);
    return result_;
  }

 private:
  [[nodiscard]] double time(size_t row) const { return trace_.at(row, 1); }

  simulator::ReplayTick tickOf(size_t row) const {
    simulator::ReplayTick tick{time(row), {}};
    for (size_t i = 0; i < columns_.size(); ++i) {
      tick.readings.push_back({m_.sensors[i].id, trace_.at(row, columns_[i])});
    }
    return tick;
  }

  ir::TickResult step(size_t row, const std::vector<double>& parameters) {
    std::vector<ir::SensorUpdate> frame;
    for (uint32_t i = 0; i < columns_.size(); ++i) {
      const double raw = trace_.at(row, columns_[i]);
      // Nothing is received before the mission has begun, nor when there is nothing.
      if (!m_.sensors[i].isHeard() || (row != 0 && !std::isnan(raw))) {
        frame.push_back({{i}, raw});
      }
    }
    ir::TickResult result =
        row == 0 ? interpreter_.start(frame, parameters) : interpreter_.tick(time(row), frame);
    monitor_.tick(interpreter_, time(row), result,
                  depth_ < 0 ? std::nan("") : trace_.at(row, depth_));
    return result;
  }

  std::unexpected<support::Failure> differs(const std::string& how) const {
    return support::fail(support::diagnostics::replayDiffers, how);
  }

  Result<void> compare(const simulator::ReplayAnswer& answer, const ir::TickResult& expected,
                       double when) {
    if (!answer.answered) {
      return differs(fmt::format("it does not answer at {:.6g} s", when));
    }
    const std::string& name = m_[expected.state].name;
    if (answer.finished != expected.finished) {
      return differs(fmt::format("at {:.6g} s it {} ended, but {}", when,
                                 answer.finished ? "has" : "has not",
                                 expected.finished ? "should have" : "should not have"));
    }
    const std::string built =
        answer.state < built_states_.size() ? built_states_[answer.state] : "";
    if (!expected.finished && (built != name || answer.stack_depth != expected.stack.size())) {
      return differs(
          fmt::format("at {:.6g} s it is in `{}` with call depth {}, not in `{}` with {}", when,
                      built, answer.stack_depth, name, expected.stack.size()));
    }
    return {};
  }

  const support::Trace& trace_;
  const std::vector<std::string>& built_states_;
  const ir::Mission& m_;
  const platforms::Platform& platform_;
  std::vector<int> columns_;
  int depth_;
  ir::Interpreter interpreter_;
  ir::RequirementMonitor monitor_;
  Replayed result_;
};

}  // namespace

Result<void> checkTrace(const support::Trace& trace, const std::string& name,
                        const compiler::Checked& checked) {
  const ir::Mission& mission = checked.mission();
  auto refuse = [&](const std::string& why) {
    return support::fail(support::diagnostics::traceNotOfMission, name, why);
  };
  if (!trace.requirement) {
    return refuse("it records a flight and violates no requirement");
  }
  if (trace.mission != mission.name) {
    return refuse(
        fmt::format("it is for mission `{}`, but this is `{}`", trace.mission, mission.name));
  }
  if (*trace.requirement >= mission.requirements.size()) {
    return refuse("the mission has only " +
                  support::counted(mission.requirements.size(), "requirement"));
  }
  if (trace.column("missiontime") != 1) {
    return refuse("it has no mission times");
  }
  for (const ir::Sensor& sensor : mission.sensors) {
    if (trace.column(sensor.vehicle_name) < 0) {
      return refuse(fmt::format("it has no readings of `{}`", sensor.vehicle_name));
    }
    if (sensor.isHeard() && trace.rowCount() != 0 &&
        !std::isnan(trace.at(0, trace.column(sensor.vehicle_name)))) {
      return refuse(
          fmt::format("it begins with a value of `{}`, but nothing is received before "
                      "the mission has begun",
                      sensor.name));
    }
  }
  return {};
}

Result<Replayed> replayRun(const support::Trace& trace, const compiler::Checked& mission,
                           const std::vector<std::string>& built_states,
                           const std::vector<double>& parameters, simulator::SbcPort& sbc) {
  return Replay(trace, mission, built_states).run(sbc, parameters);
}

}  // namespace glider::analysis
