// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/naps/wake.h"

#include "ir/core/sampling.h"
#include "ir/naps/course.h"
#include "ir/naps/wake_of_truth.h"
#include "ir/naps/wake_tree.h"

#include <algorithm>
#include <ranges>
#include <utility>

namespace glider::ir {
namespace {

class WakeOfState {
 public:
  WakeOfState(const Mission& mission, StateId state)
      : mission_(mission), state_(state), truth_(mission) {}

  Wake make() {
    const State& state = mission_[state_];
    // A C function is called once in each tick, and not for this.
    const bool calls_c = !mission_.uses.empty();
    if (samplingChanges(mission_, state) || !mission_.shares.empty() || calls_c) {
      return awake(state.head);
    }
    Wake wake = both(list(ListKind::Always, mission_.always), list(ListKind::State, state.cases));
    wake = both(std::move(wake), activity(ListKind::Profile, state.profile));
    return both(std::move(wake), activity(ListKind::Route, state.route));
  }

 private:
  Wake activity(ListKind kind, const Activity& activity) {
    const bool in_c = !mission_[activity.behaviour].symbol.empty();
    return in_c ? awake(activity.range) : list(kind, activity.cases, activity.done);
  }

  /// The next tick fires the first case whose guard is true: the one that would fire now if it
  /// also fired in this tick, as what it commands is in force then.
  Wake list(ListKind kind, const std::vector<Case>& cases, VariableId done = {}) {
    Wake wake = repeats(kind, Wake::kNoCase);
    for (auto i = static_cast<uint32_t>(cases.size()); i-- > 0;) {
      const Case& one = cases[i];
      if (kind == ListKind::Always && !mayFireHere(one)) {
        continue;
      }
      Wake fires = both(repeats(kind, i), whileItFires(one, done));
      wake = branch(one.guard, false, std::move(fires),
                    both(truth_.becomes(one.guard, true), std::move(wake)));
    }
    return wake;
  }

  /// L1: a case of `always` does not lead to the state that is current.
  [[nodiscard]] bool mayFireHere(const Case& one) const {
    const bool leads = one.transition == Transition::Goto || one.transition == Transition::Call;
    return !leads || one.target != state_;
  }

  Wake whileItFires(const Case& one, VariableId done) {
    if (!staysIn(one.transition)) {
      return awake(one.range);
    }
    Wake wake = both(truth_.leaves(one.guard, true), block(one.action));
    if (one.transition == Transition::Done) {
      Wake is_done;
      is_done.kind = WakeKind::Keeps;
      is_done.variable = done;
      wake = both(std::move(wake), std::move(is_done));
    }
    return wake;
  }

  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  Wake block(BlockId id) {
    Wake wake;
    if (id.valid()) {
      for (const Statement& statement : mission_[id].statements) {
        wake = both(std::move(wake), this->statement(statement));
      }
    }
    return wake;
  }

  /// What a statement that runs in each tick leaves as it is, or what changes that.
  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  Wake statement(const Statement& statement) {
    switch (statement.kind) {
      case StatementKind::Set:
        return set(statement);
      case StatementKind::If:
        return condition(statement);
      case StatementKind::Command:
        return std::ranges::all_of(statement.values, [&](ExprId id) { return isFixed(id); })
                   ? Wake{}
                   : awake(statement.range);
      case StatementKind::Log:
        break;
    }
    return awake(statement.range);
  }

  Wake set(const Statement& statement) {
    Wake keeps;
    keeps.kind = WakeKind::Keeps;
    keeps.variable = statement.variable;
    keeps.right = statement.value;
    if (isFixed(statement.value)) {
      return keeps;
    }
    const bool is_truth = mission_[statement.value].type.kind == TypeKind::Bool;
    return is_truth ? both(std::move(keeps), truth_.changes(statement.value))
                    : awake(statement.range);
  }

  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  Wake condition(const Statement& statement) {
    const ExprId test = statement.value;
    Wake then = both(truth_.leaves(test, true), block(statement.then));
    Wake otherwise = both(truth_.leaves(test, false), block(statement.otherwise));
    Wake neither = both(truth_.becomes(test, true), truth_.becomes(test, false));
    return branch(test, false, std::move(then),
                  branch(test, true, std::move(otherwise), std::move(neither)));
  }

  [[nodiscard]] bool isFixed(ExprId id) const { return courseOf(mission_, id) == Course::Fixed; }

  const Mission& mission_;
  StateId state_;
  WakeOfTruth truth_;
};

}  // namespace

Wake wakeOf(const Mission& mission, StateId state) {
  return WakeOfState(mission, state).make();
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
bool maySleep(const Wake& wake) {
  switch (wake.kind) {
    case WakeKind::Awake:
      return false;
    case WakeKind::All:
      return std::ranges::all_of(wake.parts, maySleep);
    case WakeKind::Branch:
      return std::ranges::any_of(wake.parts, maySleep);
    case WakeKind::Nothing:
    case WakeKind::Until:
    case WakeKind::Crossed:
    case WakeKind::Known:
    case WakeKind::Lost:
    case WakeKind::Repeats:
    case WakeKind::Keeps:
      break;
  }
  return true;
}

}  // namespace glider::ir
