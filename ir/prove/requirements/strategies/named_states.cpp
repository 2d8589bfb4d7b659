// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/evidence/configurations.h"
#include "ir/prove/requirements/strategy.h"
#include "ir/prove/requirements/trace_search.h"

#include <algorithm>
#include <utility>

namespace glider::ir::prove {
namespace {

/// Missions with more configurations are not looked at.
constexpr size_t kMostConfigurations = 5000;

/// The states that the monitor of a requirement observes.
std::vector<bool> observedStates(const Mission& mission, const Requirement& requirement) {
  std::vector<bool> observed(mission.states.size(), false);
  for (const Observation& observation : requirement.monitor.observations) {
    if (observation.kind != ObservationKind::Ended) {
      observed[observation.state.index] = true;
    }
  }
  return observed;
}

/// None if it would be the whole mission.
std::optional<Scope> scopeOf(const Requirement& requirement, const Mission& mission,
                             Insight& insight) {
  Scope scope{observedStates(mission, requirement), {}, {}, {}, false, insight.byState(), 0};
  const auto other = std::ranges::find(scope.follows, false);
  if (other == scope.follows.end() || std::ranges::count(scope.follows, true) == 0) {
    return std::nullopt;
  }
  scope.elsewhere.state = {static_cast<uint32_t>(other - scope.follows.begin())};
  for (uint32_t i = 0; i < mission.states.size(); ++i) {
    if (!scope.follows[i]) {
      scope.deepest = std::max(scope.deepest, scope.bounds[i].depth);
    }
  }
  const auto all = configurations(mission, {}, kMostConfigurations);
  if (!all) {
    return std::nullopt;
  }
  for (const Reached& reached : *all) {
    const Control& control = reached.control;
    if (!scope.holds(control)) {
      scope.others.push_back(control);
    } else if (scope.follows[control.state.index] && !control.just_returned) {
      scope.entered.push_back(control);
    }
  }
  return scope;
}

/// Spacer over the states that the promise names: the rest of the mission may do anything, within
/// what is known of every state. Missions that are too large as a whole have promises about one
/// state.
class NamedStates final : public Strategy {
 public:
  [[nodiscard]] bool serves(const Requirement& requirement) const override {
    return isPromiseOfTraces(requirement) && requirement.monitor.step.valid();
  }

  std::optional<RequirementVerdict> judge(Attempt& attempt,
                                          StrategyContext& context) const override {
    return attempt.with_power_cuts ? std::nullopt : search(attempt.requirement, context);
  }

  RepeatedProof provesAgain(const RequirementVerdict& was,
                            StrategyContext& context) const override {
    auto verdict = search(context.mission.requirements[was.requirement], context);
    return verdict ? RepeatedProof{true, std::move(verdict->evidence)} : RepeatedProof();
  }

 private:
  static std::optional<RequirementVerdict> search(const Requirement& requirement,
                                                  StrategyContext& context) {
    Insight& insight = context.insight();
    auto scope = scopeOf(requirement, context.mission, insight);
    if (!scope) {
      return std::nullopt;
    }
    // Most promises of a climb need no variable of the mission.
    for (const bool fine : {false, true}) {
      scope->fine = fine;
      RunsAnswer answer = provenWithin(requirement, *scope, insight, context);
      if (answer.bad == Answer::No) {
        return provedBy(std::move(answer), requirement, context);
      }
    }
    return std::nullopt;
  }
};

}  // namespace

const Strategy& strategy::namedStates() {
  static const NamedStates kStrategy;
  return kStrategy;
}

}  // namespace glider::ir::prove
