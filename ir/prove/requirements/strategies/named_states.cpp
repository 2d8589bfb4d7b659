// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/walk.h"
#include "ir/prove/abstract/puts_off.h"
#include "ir/prove/encoding/safety_properties.h"
#include "ir/prove/evidence/configurations.h"
#include "ir/prove/requirements/strategy.h"
#include "ir/prove/requirements/trace_search.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace glider::ir::prove {
namespace {

/// Whether a guard has one value on a tick, for all that the tick changes.
bool readsOnlyTheTick(const Mission& mission, ExprId guard) {
  return !anyIn(mission, guard, [&](const Expr& e) {
    const bool kept = e.op == Op::Variable && mission[e.variable].kind != VariableKind::Parameter;
    return kept || e.op == Op::Temporal || e.op == Op::Call || e.op == Op::StateTime ||
           e.op == Op::ResumeTime;
  });
}

/// The first cases of `always` that are certainly tried elsewhere, in order; not just after a
/// return.
std::vector<uint32_t> sureCases(const Mission& mission, const Scope& scope) {
  std::vector<uint32_t> sure;
  for (uint32_t i = 0; i < mission.always.size(); ++i) {
    const bool tried = std::ranges::all_of(
        scope.others, [&](const Control& control) { return control.mayInterrupt(mission, i); });
    if (!tried || !readsOnlyTheTick(mission, mission.always[i].guard)) {
      break;
    }
    sure.push_back(i);
  }
  return sure;
}

/// See Scope::exits: of the states that are current elsewhere, and of `always`.
std::optional<std::vector<ExprId>> exitsOf(const Mission& mission, const Scope& scope) {
  std::vector<bool> current(mission.states.size(), false);
  for (const Control& control : scope.others) {
    current[control.state.index] = true;
  }
  std::vector<ExprId> exits;
  bool any = false;
  const auto gather = [&](std::span<const Case> cases) {
    for (const Case& c : cases) {
      if (c.transition == Transition::Exit) {
        exits.push_back(c.guard);
        any = any || !readsOnlyTheTick(mission, c.guard);
      }
    }
  };
  gather(mission.always);
  for (uint32_t i = 0; i < mission.states.size(); ++i) {
    if (current[i]) {
      gather(mission.states[i].cases);
    }
  }
  return any ? std::nullopt : std::optional(std::move(exits));
}

/// None if it would be nothing, or the whole mission.
std::optional<Scope> scopeOf(std::vector<bool> follows, Insight& insight) {
  const Mission& mission = insight.context().mission;
  Scope scope{std::move(follows), {}, {}, {}, false, insight.byState()};
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
  const auto all = configurations(mission);
  if (!all) {
    return std::nullopt;
  }
  const PutsOff puts_off(insight.context());
  for (const Reached& reached : *all) {
    const Control& control = reached.control;
    if (!scope.holds(control)) {
      scope.others.push_back(control);
      scope.returns = scope.returns || puts_off.at(control);
      scope.returns_again = scope.returns_again || puts_off.again(control);
    } else if (scope.follows[control.state.index] && !control.just_returned) {
      scope.entered.push_back(control);
    }
  }
  scope.sure = sureCases(mission, scope);
  scope.exits = exitsOf(mission, scope);
  return scope;
}

/// The states that its monitor observes; for a depth also those that only climb, with them.
std::vector<Scope> scopesFor(const Requirement& requirement, const StrategyContext& context,
                             Insight& insight) {
  const Mission& mission = context.mission;
  std::vector<bool> follows;
  for (uint32_t i = 0; i < mission.states.size(); ++i) {
    follows.push_back(observes(requirement.monitor, {i}));
  }
  std::vector<Scope> scopes;
  if (auto scope = scopeOf(follows, insight)) {
    scopes.push_back(*std::move(scope));
  }
  if (!awaitedDepths(requirement, insight.context()).empty()) {
    const std::vector<bool> observed = follows;
    for (size_t i = 0; i < follows.size(); ++i) {
      follows[i] = follows[i] || insight.byState()[i].climbs;
    }
    auto scope = follows == observed ? std::nullopt : scopeOf(follows, insight);
    if (scope) {
      scopes.push_back(*std::move(scope));
    }
  }
  return scopes;
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
    return againBy(search(context.mission.requirements[was.requirement], context));
  }

 private:
  static std::optional<RequirementVerdict> search(const Requirement& requirement,
                                                  StrategyContext& context) {
    Insight& insight = context.insight();
    std::vector<Scope> scopes = scopesFor(requirement, context, insight);
    struct Manner {
      bool fine;
      Lemmas lemmas;
    };
    // Most promises of a climb need no variable of the mission.
    for (const auto& [fine, lemmas] : {Manner{false, Lemmas::Farkas}, Manner{true, Lemmas::Farkas},
                                       Manner{true, Lemmas::Elimination}}) {
      for (Scope& scope : scopes) {
        scope.fine = fine;
        if (auto verdict = provedIf(provenWithin(requirement, scope, insight, context, lemmas),
                                    requirement, context)) {
          return verdict;
        }
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
