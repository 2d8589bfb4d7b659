// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/timers.h"

#include "ir/core/walk.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace glider::ir::prove {
namespace {

constexpr double kNoEnd = std::numeric_limits<double>::infinity();

class TimerSearch {
 public:
  TimerSearch(const ProofContext& proof_context, const Valuation& values, double ends_by,
              const std::function<bool(ExprId)>& may_fire_under_water)
      : m_(proof_context.mission),
        may_fire_under_water_(may_fire_under_water),
        guards_(proof_context, values, ends_by),
        set_outside_(m_.variables.size()) {
    const auto note = [&](const Statement& s) {
      if (s.kind == StatementKind::Set) {
        set_outside_[s.variable.index] = true;
      }
    };
    forEachStatement(m_, m_.every_tick, note);
    for (const State& state : m_.states) {
      for (const BlockId entry : {state.entry, state.profile.entry, state.route.entry}) {
        forEachStatement(m_, entry, note);
      }
    }
  }

  std::vector<Timer> all() {
    std::vector<Timer> found;
    for (uint32_t i = 0; i < m_.variables.size(); ++i) {
      if (isTimer({i})) {
        Timer one = timer({i});
        if (one.bounds()) {
          found.push_back(std::move(one));
        }
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
    return initial.op == Op::Constant && initial.number <= 0 && !set_outside_[id.index] &&
           guards_.holdsTimesOnly(id);
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
      return staysIn(c.transition) && sets(m_, c.action, since) && may_fire_under_water_(c.guard);
    });
  }

  /// The first case of a list that leads away when enough time has passed, if no case before it
  /// may fire under water and stay: then the list is tried no further.
  [[nodiscard]] TimerCase firstThatLeads(const std::vector<Case>& cases, VariableId since) const {
    for (size_t i = 0; i < cases.size(); ++i) {
      if (staysIn(cases[i].transition)) {
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
  std::vector<bool> set_outside_;  ///< of each variable: something but a case sets it
};

}  // namespace

std::vector<Timer> timersOf(const ProofContext& proof_context, const Valuation& values,
                            double ends_by,
                            const std::function<bool(ExprId)>& may_fire_under_water) {
  return TimerSearch(proof_context, values, ends_by, may_fire_under_water).all();
}

}  // namespace glider::ir::prove
