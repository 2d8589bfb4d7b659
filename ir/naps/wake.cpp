// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/naps/wake.h"

#include "ir/core/ops.h"
#include "ir/core/sampling.h"
#include "ir/core/truth.h"
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
      wake = both(std::move(wake), keeps(done));
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
    Wake same = keeps(statement.variable, statement.value);
    if (isFixed(statement.value)) {
      return same;
    }
    const bool is_truth = mission_[statement.value].type.kind == TypeKind::Bool;
    return is_truth ? both(std::move(same), truth_.changes(statement.value))
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

namespace {

/// What is certain of a truth value while all sensors are known.
// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
Truth whileAllIsKnown(const Mission& mission, ExprId id) {
  const Expr& e = mission[id];
  if (e.op == Op::Known && mission[e.operands[0]].op == Op::Sensor) {
    return Truth::True;
  }
  if (groupOf(e.op) == OpGroup::Truth) {
    return truth(e.op == Op::True);
  }
  if (groupOf(e.op) != OpGroup::Logic) {
    return Truth::Unknown;
  }
  return logical(opIn<LogicOp>(e.op),
                 [&](size_t i) { return whileAllIsKnown(mission, e.operands.at(i)); });
}

}  // namespace

// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
const Wake* whatKeepsAwake(const Mission& mission, const Wake& wake) {
  const auto in = [&](const Wake& part) { return whatKeepsAwake(mission, part); };
  switch (wake.kind) {
    case WakeKind::Awake:
      return &wake;
    case WakeKind::All: {
      const auto one = std::ranges::find_if(wake.parts, in);
      return one == wake.parts.end() ? nullptr : in(*one);
    }
    case WakeKind::Branch: {
      const Truth test = whileAllIsKnown(mission, wake.test);
      const Wake* yes = test == truth(wake.of_false) ? nullptr : in(wake.parts[0]);
      const Wake* no = test == truth(!wake.of_false) ? nullptr : in(wake.parts[1]);
      return test != Truth::Unknown ? (yes ? yes : no) : yes ? no : nullptr;
    }
    case WakeKind::Nothing:
    case WakeKind::Until:
    case WakeKind::Crossed:
    case WakeKind::Known:
    case WakeKind::Lost:
    case WakeKind::Repeats:
    case WakeKind::Keeps:
      break;
  }
  return nullptr;
}

bool maySleep(const Mission& mission, const Wake& wake) {
  return whatKeepsAwake(mission, wake) == nullptr;
}

}  // namespace glider::ir
