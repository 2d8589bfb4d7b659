// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/requirement_watch.h"

#include "flights/broken_assumption.h"
#include "flights/flight_setup.h"
#include "flights/known_flight.h"
#include "support/diagnostics/ids/vehicle.h"
#include "support/one_line.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::flights {
RequirementWatch::RequirementWatch(const compiler::Optimised& mission)
    : flown_(mission), m_(mission.checked->mission()), heard_(m_) {}

bool RequirementWatch::canWatch(const compiler::Optimised& mission) {
  const ir::Mission& m = mission.checked->mission();
  return !needsCodeInC(m) && (!m.requirements.empty() || !m.assumptions.empty() || m.nap_s);
}

InProcessSbc::Watcher RequirementWatch::watcher(const std::vector<double>& parameters,
                                                std::optional<double> kept) {
  parameters_ = parameters;
  heard_.starts(kept);
  return [this, start = ++starts_](const GliderContext& context, double now) {
    if (!departed_) {
      heard_.look(context, now);
      outages_.look(start, context.mission_time, now, context.state);
      naps_.look(context, now);
    }
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

/// When a mission breaks an assumption, without its number.
std::optional<FlownViolation> firstBreak(const ir::Assumption& assumption,
                                         const KnownFlight& flight) {
  if (assumption.isWatched()) {
    return outcomeOf(assumption.watch, flight, false).violation;
  }
  return flight.heard.ticks.empty()
             ? std::nullopt
             : breakInTrace(assumption, flight.trace, flight.heard.ticks.front().heard);
}

/// A mission without outages.
HeardMission undisturbed(std::span<const HeardTick> ticks) {
  HeardMission heard;
  for (const HeardTick& tick : ticks) {
    const size_t number = heard.ticks.size();
    heard.ticks.push_back({tick, number == 0 ? std::nullopt : std::optional(number - 1), false});
  }
  return heard;
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
  auto found =
      outcomeOf(required, {mission, undisturbed(ticks), parameters, trace}, false).violation;
  if (found) {
    found->number = requirement;
  }
  return found;
}

std::optional<double> firstBrokenAssumption(const compiler::Optimised& mission,
                                            std::span<const HeardTick> ticks,
                                            const std::vector<double>& parameters,
                                            const support::Trace& trace) {
  const HeardMission heard = undisturbed(ticks);
  std::optional<double> first;
  for (const ir::Assumption& assumption : mission.checked->mission().assumptions) {
    if (const auto found = firstBreak(assumption, {mission, heard, parameters, trace})) {
      first = std::min(found->mission_time, first.value_or(found->mission_time));
    }
  }
  return first;
}

KnownOutcome RequirementWatch::firstOf(
    const support::Trace& trace,
    const std::function<KnownOutcome(const KnownFlight&, bool)>& look) const {
  KnownOutcome outcome;
  for (const HeardMission& heard : heard_.missions()) {
    const bool last = &heard == &heard_.missions().back();
    outcome = look({flown_, heard, parameters_, trace}, last && !departed_);
    if (outcome.violation) {
      FlownViolation& found = *outcome.violation;
      found.after += outagesBefore(heard, found.vehicle_time);
      if (&heard != &heard_.missions().front()) {
        found.after += std::string(found.after.empty() ? "" : ", ") + "the mission had begun again";
      }
      return outcome;
    }
  }
  return outcome;
}

FlownOutcome RequirementWatch::outcome(const support::Trace& trace) const {
  FlownOutcome all;
  for (size_t i = 0; i < m_.requirements.size(); ++i) {
    const ir::Requirement& required = m_.requirements[i];
    if (required.kind == ir::RequirementKind::Reach) {
      continue;  // it says what some flight can do
    }
    auto found = firstOf(trace, [&](const auto& flight, bool to_end) {
      return outcomeOf(required, flight, to_end);
    });
    if (found.violation) {
      found.violation->number = i;
      all.violations.push_back(*std::move(found.violation));
    } else if (heard_.missions().empty() && !departed_) {
      all.undecided.push_back({i, "the mission did not begin"});
    } else if (!found.undecided.empty()) {
      all.undecided.push_back({i, std::move(found.undecided)});
    }
  }
  for (size_t i = 0; i < m_.assumptions.size(); ++i) {
    auto found = firstOf(trace, [&](const auto& flight, bool) {
      return KnownOutcome{firstBreak(m_.assumptions[i], flight), ""};
    });
    if (!found.violation) {
      found.violation = tooLong(m_.assumptions[i]);
    }
    if (found.violation) {
      found.violation->number = m_.requirements.size() + i;
      all.violations.push_back(*std::move(found.violation));
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

void reportViolations(const RequirementWatch& watch, const std::vector<FlownViolation>& found,
                      support::DiagnosticEngine& diagnostics) {
  const ir::Mission& m = watch.mission();
  for (const FlownViolation& one : found) {
    const bool assumption = one.number >= m.requirements.size();
    diagnostics.report(
        assumption ? support::diagnostics::assumptionFlown : support::diagnostics::requirementFlown,
        assumption ? m.assumptions[one.number - m.requirements.size()].range
                   : m.requirements[one.number].range,
        fmt::format("at mission time {:.6g} s{}{}{}{}{}", one.mission_time,
                    one.state.empty() ? "" : fmt::format(", in state `{}`", one.state),
                    one.words.empty() ? "" : ", ", one.words, one.after.empty() ? "" : "; ",
                    one.after));
  }
  if (const auto at = watch.departed()) {
    diagnostics.report(support::diagnostics::watchEnded, {}, fmt::format("{:.0f} s", *at));
  }
}

}  // namespace glider::flights
