// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/timers.h"

#include "ir/prove/abstract/timer_guards.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glider::ir::prove {
namespace {

constexpr double kNoEnd = std::numeric_limits<double>::infinity();

class TimerSearch {
 public:
  TimerSearch(const ProofContext& proof_context, const Valuation& values, double ends_by,
              const std::function<bool(ExprId)>& may_fire_under_water)
      : m_(proof_context.mission),
        may_fire_under_water_(may_fire_under_water),
        guards_(proof_context, values, ends_by) {}

  std::vector<Timer> all() {
    std::vector<Timer> found;
    for (uint32_t i = 0; i < m_.variables.size(); ++i) {
      if (isTimer({i})) {
        found.push_back(timer({i}));
      }
    }
    return found;
  }

 private:
  [[nodiscard]] bool isTimer(VariableId id) const {
    const Variable& variable = m_[id];
    if (variable.kind != VariableKind::Mission || variable.type.kind != TypeKind::Quantity ||
        std::isfinite(variable.lowest) || std::isfinite(variable.highest)) {
      return false;
    }
    const Expr& initial = m_[variable.initial];
    return initial.op == Op::Constant && initial.number <= 0 && isSetInCasesOnly(id) &&
           holdsTimesOnly(m_, id);
  }

  /// Nothing that runs when a state becomes current, and nothing outside a case, sets it.
  [[nodiscard]] bool isSetInCasesOnly(VariableId id) const {
    return !sets(m_, m_.every_tick, id) && std::ranges::none_of(m_.states, [&](const State& state) {
      return sets(m_, state.entry, id) || sets(m_, state.profile.entry, id) ||
             sets(m_, state.route.entry, id);
    });
  }

  Timer timer(VariableId since) {
    Timer timer{since, firstThatLeads(m_.always, since), {}, {}, {}};
    timer.kept = keptFrom(timer.always.number);
    const bool always_sets = stayingSets(m_.always, since);
    for (const State& state : m_.states) {
      timer.own.push_back(firstThatLeads(state.cases, since));
      timer.set_under_water.push_back(always_sets || stayingSets(state.cases, since) ||
                                      stayingSets(state.profile.cases, since) ||
                                      stayingSets(state.route.cases, since));
    }
    return timer;
  }

  /// Whether a case that does not lead away may set it under water.
  [[nodiscard]] bool stayingSets(const std::vector<Case>& cases, VariableId since) const {
    return std::ranges::any_of(cases, [&](const Case& c) {
      return staysIn(c) && sets(m_, c.action, since) && may_fire_under_water_(c.guard);
    });
  }

  static bool staysIn(const Case& c) {
    return c.transition == Transition::Stay || c.transition == Transition::Done;
  }

  /// The first case of a list that leads away when enough time has passed, if no case before it
  /// may fire under water and stay: then the list is tried no further.
  [[nodiscard]] TimerCase firstThatLeads(const std::vector<Case>& cases, VariableId since) const {
    for (size_t i = 0; i < cases.size(); ++i) {
      if (staysIn(cases[i])) {
        if (may_fire_under_water_(cases[i].guard)) {
          break;
        }
        continue;
      }
      const double longest = guards_.trueAfter(cases[i].guard, since, [](ExprId) { return false; });
      if (std::isfinite(longest)) {
        return {i, longest};
      }
    }
    return {};
  }

  /// The states in which case `number` of `always` may be kept from firing (L1 to L4): its target,
  /// what a case before it leads to, and what these call, or `always` calls from these.
  [[nodiscard]] std::vector<bool> keptFrom(size_t number) const {
    std::vector<bool> kept(m_.states.size());
    std::vector<uint32_t> open;
    const auto keep = [&](StateId state) {
      if (state.valid() && !kept[state.index]) {
        kept[state.index] = true;
        open.push_back(state.index);
      }
    };
    for (size_t i = 0; i < m_.always.size(); ++i) {
      if (i <= number || m_.always[i].transition == Transition::Call) {
        keep(m_.always[i].target);
      }
    }
    for (size_t next = 0; next < open.size(); ++next) {
      for (const Case& c : m_.states[open[next]].cases) {
        if (c.transition == Transition::Call) {
          keep(c.target);
        }
      }
    }
    return kept;
  }

  const Mission& m_;
  const std::function<bool(ExprId)>& may_fire_under_water_;
  TimerGuards guards_;
};

}  // namespace

std::vector<Timer> timersOf(const ProofContext& proof_context, const Valuation& values,
                            double ends_by,
                            const std::function<bool(ExprId)>& may_fire_under_water) {
  return TimerSearch(proof_context, values, ends_by, may_fire_under_water).all();
}

}  // namespace glider::ir::prove
