// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/timers.h"

#include "ir/core/walk.h"

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
        ends_by_(ends_by),
        may_fire_under_water_(may_fire_under_water),
        evaluator_(proof_context, values,
                   {{0, kGreatestNumber, false},
                    {0, kGreatestNumber, false},
                    {0, kGreatestNumber, false}}) {}

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
           setsOf(id, [&](ExprId value) { return m_[value].op == Op::MissionTime; });
  }

  /// Whether all values that are assigned to the variable, at least one, are so.
  template <typename Predicate>
  [[nodiscard]] bool setsOf(VariableId id, Predicate is) const {
    bool any = false;
    for (const Block& block : m_.blocks) {
      for (const Statement& s : block.statements) {
        if (s.kind == StatementKind::Set && s.variable == id) {
          any = true;
          if (!is(s.value)) {
            return false;
          }
        }
      }
    }
    return any;
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
      const double longest = trueAfter(cases[i].guard, since);
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

  /// The guard is certainly true when the mission time is more than this after `since`, s; infinite
  /// if that is not known. It reads `missiontime - since > T`, or compares so, or is an `||` of it.
  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  [[nodiscard]] double trueAfter(ExprId id, VariableId since) const {
    const Expr& e = m_[id];
    switch (e.op) {
      case Op::Or:
        return std::min(trueAfter(e.operands[0], since), trueAfter(e.operands[1], since));
      case Op::Greater:
      case Op::GreaterEqual:
        return apart(e.operands[0], e.operands[1], since);
      case Op::Less:
      case Op::LessEqual:
        return apart(e.operands[1], e.operands[0], since);
      default:
        return kNoEnd;
    }
  }

  /// The longest time after `since` at which `more` > `less` may be false.
  [[nodiscard]] double apart(ExprId more, ExprId less, VariableId since) const {
    const Expr& a = m_[more];
    const Expr& b = m_[less];
    if (a.op == Op::Subtract && m_[a.operands[0]].op == Op::MissionTime &&
        isSince(a.operands[1], since)) {
      return mostOf(less);
    }
    if (a.op != Op::MissionTime || b.op != Op::Add) {
      return kNoEnd;
    }
    const bool first = isSince(b.operands[0], since);
    if (!first && !isSince(b.operands[1], since)) {
      return kNoEnd;
    }
    // The sum, about the mission time, was rounded; the later, the more.
    const double most = mostOf(b.operands[first ? 1 : 0]);
    return most + (most + ends_by_) * 0x1p-50;
  }

  [[nodiscard]] bool isSince(ExprId id, VariableId since) const {
    return m_[id].op == Op::Variable && m_[id].variable == since;
  }

  /// The greatest value of an expression that is never unknown, and what rounding adds at most.
  [[nodiscard]] double mostOf(ExprId id) const {
    constexpr double kRoundedUp = 1 + 0x1p-40;
    constexpr double kSettled = 1e-6;
    if (evaluator_.maybeUnknown(id)) {
      return kNoEnd;
    }
    const double most = std::max(evaluator_.number(id).highest, 0.0);
    return most < kGreatestNumber ? most * kRoundedUp + kSettled : kNoEnd;
  }

  const Mission& m_;
  double ends_by_;
  const std::function<bool(ExprId)>& may_fire_under_water_;
  AbstractEvaluator evaluator_;
};

}  // namespace

std::vector<Timer> timersOf(const ProofContext& proof_context, const Valuation& values,
                            double ends_by,
                            const std::function<bool(ExprId)>& may_fire_under_water) {
  return TimerSearch(proof_context, values, ends_by, may_fire_under_water).all();
}

bool sets(const Mission& mission, BlockId block, VariableId variable) {
  bool found = false;
  forEachStatement(mission, block, [&](const Statement& s) {
    found = found || (s.kind == StatementKind::Set && s.variable == variable);
  });
  return found;
}

}  // namespace glider::ir::prove
