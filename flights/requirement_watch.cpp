// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/requirement_watch.h"

#include "flights/broken_assumption.h"
#include "flights/flight_setup.h"
#include "ir/prove/context/proof_context.h"
#include "ir/prove/context/requirement_monitor.h"
#include "support/diagnostics/catalogue.h"
#include "support/one_line.h"

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
  return !needsCodeInC(m) && !(m.requirements.empty() && m.assumptions.empty());
}

InProcessSbc::Watcher RequirementWatch::watcher(const std::vector<double>& parameters) {
  parameters_ = parameters;
  return [this, start = ++starts_](const GliderContext& context, double now) {
    if (start == 1) {
      heard_.look(context, now);
    }
    outages_.look(start, context.mission_time, now, context.state);
  };
}

/// The tick after a restart, which ends an outage longer than the assumed one.
std::optional<FlownViolation> RequirementWatch::tooLong(const ir::Assumption& assumption) const {
  if (assumption.kind != ir::AssumptionKind::Outage) {
    return std::nullopt;
  }
  const double limit = std::max(assumption.limit, flown_.platform().world.tick_gap_s);
  const auto found = std::ranges::find_if(
      outages_.found(), [&](const Outage& outage) { return outage.to_s - outage.from_s > limit; });
  if (found == outages_.found().end()) {
    return std::nullopt;
  }
  return FlownViolation{0, found->to_s, found->vehicle_time,
                        flown_.mission.states.at(found->state).name,
                        fmt::format("there was no tick for {:.0f} s", found->to_s - found->from_s)};
}

namespace {

/// What one flight is checked with.
struct Flight {
  const compiler::Optimised& mission;
  std::span<const HeardTick> ticks;
  const std::vector<double>& parameters;
  const support::Trace& trace;
};

/// The first violation of `required`, without its number.
std::optional<FlownViolation> firstViolation(const ir::Requirement& required,
                                             const Flight& flight) {
  const ir::Mission& m = flight.mission.checked->mission();
  const platforms::Platform& platform = flight.mission.platform();
  ir::Interpreter interpreter(m, flight.mission.checked->facts.stack_depth);
  ir::RequirementMonitor monitor(m, required, platform.world.surface_depth_m,
                                 ir::prove::depthSensor(m, platform));
  TrueDepth depth(flight.trace);
  bool started = false;
  for (const HeardTick& tick : flight.ticks) {
    const auto result = started ? interpreter.tick(tick.mission_time, tick.frame)
                                : interpreter.start(tick.frame, flight.parameters);
    started = true;
    monitor.tick(interpreter, tick.mission_time, result, depth.at(tick.vehicle_time));
    if (monitor.when()) {
      return FlownViolation{0, tick.mission_time, tick.vehicle_time, m[result.state].name,
                            monitor.words()};
    }
  }
  return std::nullopt;
}

/// When the flight breaks an assumption, without its number.
std::optional<FlownViolation> firstBreak(const ir::Assumption& assumption, const Flight& flight) {
  if (assumption.isWatched()) {
    return firstViolation(assumption.watch, flight);
  }
  return flight.ticks.empty() ? std::nullopt
                              : breakInTrace(assumption, flight.trace, flight.ticks.front());
}

}  // namespace

std::optional<FlownViolation> violationOf(const compiler::Optimised& mission, size_t requirement,
                                          std::span<const HeardTick> ticks,
                                          const std::vector<double>& parameters,
                                          const support::Trace& trace) {
  const ir::Requirement& required = mission.checked->mission().requirements.at(requirement);
  if (required.kind == ir::RequirementKind::Reach) {
    return std::nullopt;  // it says what some flight can do
  }
  auto found = firstViolation(required, {mission, ticks, parameters, trace});
  if (found) {
    found->number = requirement;
  }
  return found;
}

std::optional<double> firstBrokenAssumption(const compiler::Optimised& mission,
                                            std::span<const HeardTick> ticks,
                                            const std::vector<double>& parameters,
                                            const support::Trace& trace) {
  std::optional<double> first;
  for (const ir::Assumption& assumption : mission.checked->mission().assumptions) {
    if (const auto found = firstBreak(assumption, {mission, ticks, parameters, trace})) {
      first = std::min(found->mission_time, first.value_or(found->mission_time));
    }
  }
  return first;
}

std::vector<FlownViolation> RequirementWatch::violations(const support::Trace& trace) const {
  std::vector<FlownViolation> all;
  for (size_t i = 0; i < m_.requirements.size(); ++i) {
    if (auto found = violationOf(flown_, i, heard_.ticks(), parameters_, trace)) {
      all.push_back(*std::move(found));
    }
  }
  for (size_t i = 0; i < m_.assumptions.size(); ++i) {
    auto found = firstBreak(m_.assumptions[i], {flown_, heard_.ticks(), parameters_, trace});
    if (!found) {
      found = tooLong(m_.assumptions[i]);
    }
    if (found) {
      found->number = m_.requirements.size() + i;
      all.push_back(*std::move(found));
    }
  }
  return all;
}

std::vector<std::string> watchedTexts(const compiler::Checked& mission) {
  std::vector<std::string> texts;
  for (const ir::Requirement& requirement : mission.mission().requirements) {
    texts.push_back(support::onOneLine(mission.sources().text(requirement.range)));
  }
  for (const ir::Assumption& assumption : mission.mission().assumptions) {
    texts.push_back(support::onOneLine(mission.sources().text(assumption.range)));
  }
  return texts;
}

void reportViolations(const RequirementWatch& watch, const support::Trace& trace,
                      support::DiagnosticEngine& diagnostics) {
  const ir::Mission& m = watch.mission();
  for (const FlownViolation& found : watch.violations(trace)) {
    const bool assumption = found.number >= m.requirements.size();
    diagnostics.report(
        assumption ? support::DiagnosticId::assumptionFlown
                   : support::DiagnosticId::requirementFlown,
        assumption ? m.assumptions[found.number - m.requirements.size()].range
                   : m.requirements[found.number].range,
        fmt::format("at mission time {:.6g} s, in state `{}`{}{}", found.mission_time, found.state,
                    found.words.empty() ? "" : ", ", found.words));
  }
}

}  // namespace glider::flights
