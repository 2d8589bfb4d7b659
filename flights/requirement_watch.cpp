// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/requirement_watch.h"

#include "flights/flight_setup.h"
#include "ir/prove/context/proof_context.h"
#include "ir/prove/context/requirement_monitor.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace glider::flights {
namespace {

/// The true depth (m) at vehicle times that do not fall; NaN beyond the trace.
class TrueDepth {
 public:
  explicit TrueDepth(const support::Trace& trace)
      : trace_(trace), column_(trace.column("true_depth")) {}

  double at(double time) {
    while (row_ < trace_.rowCount() && trace_.at(row_, 0) < time) {
      ++row_;
    }
    const bool there = column_ >= 0 && row_ < trace_.rowCount();
    return there ? trace_.at(row_, column_) : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  const support::Trace& trace_;
  int column_;
  size_t row_ = 0;
};

}  // namespace

RequirementWatch::RequirementWatch(const compiler::Optimised& mission)
    : flown_(mission), m_(mission.checked->mission()), heard_(m_) {}

bool RequirementWatch::canWatch(const compiler::Optimised& mission) {
  const ir::Mission& m = mission.checked->mission();
  return !needsCodeInC(m) && !m.requirements.empty();
}

InProcessSbc::Watcher RequirementWatch::watcher(const std::vector<double>& parameters) {
  parameters_ = parameters;
  return [this, start = ++starts_](const GliderContext& context, double now) {
    if (start == 1) {
      heard_.look(context, now);
    }
  };
}

std::optional<FlownViolation> violationOf(const compiler::Optimised& mission, size_t requirement,
                                          std::span<const HeardTick> ticks,
                                          const std::vector<double>& parameters,
                                          const support::Trace& trace) {
  const ir::Mission& m = mission.checked->mission();
  const ir::Requirement& required = m.requirements.at(requirement);
  if (required.kind == ir::RequirementKind::Reach) {
    return std::nullopt;  // it says what some flight can do
  }
  ir::Interpreter interpreter(m, mission.checked->facts.stack_depth);
  ir::RequirementMonitor monitor(m, required, mission.platform().world.surface_depth_m,
                                 ir::prove::depthSensor(m, mission.platform()));
  TrueDepth depth(trace);
  bool started = false;
  for (const HeardTick& tick : ticks) {
    const auto result = started ? interpreter.tick(tick.mission_time, tick.frame)
                                : interpreter.start(tick.frame, parameters);
    started = true;
    monitor.tick(interpreter, tick.mission_time, result, depth.at(tick.vehicle_time));
    if (monitor.when()) {
      return FlownViolation{requirement, tick.mission_time, tick.vehicle_time, m[result.state].name,
                            monitor.words()};
    }
  }
  return std::nullopt;
}

std::vector<FlownViolation> RequirementWatch::violations(const support::Trace& trace) const {
  std::vector<FlownViolation> all;
  for (size_t i = 0; i < m_.requirements.size(); ++i) {
    if (auto found = violationOf(flown_, i, heard_.ticks(), parameters_, trace)) {
      all.push_back(*std::move(found));
    }
  }
  return all;
}

void reportViolations(const RequirementWatch& watch, const support::Trace& trace,
                      support::DiagnosticEngine& diagnostics) {
  for (const FlownViolation& found : watch.violations(trace)) {
    diagnostics.report(
        support::DiagnosticId::requirementFlown, watch.requirement(found.requirement).range,
        fmt::format("at mission time {:.6g} s, in state `{}`{}{}", found.mission_time, found.state,
                    found.words.empty() ? "" : ", ", found.words));
  }
}

}  // namespace glider::flights
