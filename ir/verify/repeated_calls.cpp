// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/ops.h"
#include "ir/core/walk.h"
#include "ir/verify/passes.h"
#include "support/diagnostics/ids/verification.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace glider::ir {
namespace {

bool isGrowingClock(Op op) {
  return op == Op::MissionTime || op == Op::StateTime;
}

/// Finds calls whose condition is certainly still true when they return, so that the first tick
/// after that calls again: `case profiledone call x`, `case missiontime >= 2 h call x`. A state
/// keeps its `statetime`, its variables and its `profiledone` while it waits.
class RepeatedCalls {
 public:
  explicit RepeatedCalls(Verification& v) : v_(v), m_(v.structure.mission) {}

  void run() {
    for (uint32_t s = 0; s < v_.structure.size(); ++s) {
      if (!v_.structure.reached(s)) {
        continue;
      }
      const auto& cases = m_.states[s].cases;
      for (uint32_t c = 0; c < cases.size(); ++c) {
        if (cases[c].transition == Transition::Call && v_.structure.moves[s].dead[c] == Dead::No) {
          look(s, c);
        }
      }
    }
  }

 private:
  /// Of more states that may be current until the return, anything may be set.
  static constexpr size_t kMostCalled = 50;

  void look(uint32_t state, uint32_t number) {
    const Case& call = m_.states[state].cases[number];
    const Moves& called = v_.structure.moves[call.target.index];
    const bool comes_true = anyIn(m_, call.guard, [](const Expr& e) {
      return isGrowingClock(e.op) || e.op == Op::Variable;
    });  // one that always is true is reported as that
    if (call.target.index == state || !called.return_case || !comes_true) {
      return;
    }
    state_ = state;
    if (readsVariables(number)) {
      findChanged(call);
    }
    if (staysTrue(call.guard) && nothingBefore(number, call.target)) {
      v_.diagnostics.report(support::diagnostics::callRepeats, call.range, m_[call.target].name,
                            hintFor(call));
    }
  }

  /// What may be set from the call to the first tick after its return.
  void findChanged(const Case& call) {
    changed_.assign(m_.variables.size(), false);
    set(call.action);
    set(m_.every_tick);
    setIn(m_.always);
    set(m_.states[state_].profile.entry);
    set(m_.states[state_].route.entry);
    called_ = {call.target.index};
    for (const Case& c : m_.always) {  // it may call while the called state is current
      if (c.transition == Transition::Call) {
        called_.push_back(c.target.index);
      }
    }
    for (size_t i = 0; i < called_.size() && i < kMostCalled; ++i) {
      const State& state = m_.states[called_[i]];
      set(state.entry);
      setIn(state.cases);
      for (const Case& c : state.cases) {
        const bool fresh = c.transition == Transition::Call &&
                           std::ranges::find(called_, c.target.index) == called_.end();
        if (fresh) {
          called_.push_back(c.target.index);  // a `goto` leads to no return
        }
      }
    }
    if (called_.size() > kMostCalled) {
      changed_.assign(m_.variables.size(), true);
    }
  }

  /// Whether it matters what is set: only then it is looked for.
  [[nodiscard]] bool readsVariables(uint32_t number) const {
    const auto& cases = m_.states[state_].cases;
    return std::any_of(cases.begin(), cases.begin() + number + 1, [&](const Case& c) {
      return anyIn(m_, c.guard, [](const Expr& e) { return groupOf(e.op) == OpGroup::Variable; });
    });
  }

  void setIn(const std::vector<Case>& cases) {
    for (const Case& c : cases) {
      set(c.action);
    }
  }

  void set(BlockId block) {
    forEachStatement(m_, block, [&](const Statement& statement) {
      if (statement.kind == StatementKind::Set) {
        changed_[statement.variable.index] = true;
      }
    });
  }

  /// Whether the expression has the same value at the call and after it.
  [[nodiscard]] bool isUnchanged(ExprId root) const {
    return !anyIn(m_, root, [&](const Expr& e) {
      switch (groupOf(e.op)) {
        case OpGroup::Constant:
        case OpGroup::Truth:
        case OpGroup::Unary:
        case OpGroup::Binary:
        case OpGroup::Function:
        case OpGroup::Comparison:
        case OpGroup::Logic:
          return false;
        case OpGroup::Variable:
          return changed_[e.variable.index];  // `profiledone` waits with its state
        case OpGroup::Sensor:
        case OpGroup::Clock:
        case OpGroup::Temporal:
        case OpGroup::Age:
        case OpGroup::Clamp:
        case OpGroup::Select:
        case OpGroup::Element:
        case OpGroup::Call:
        case OpGroup::Known:
          break;
      }
      return true;
    });
  }

  /// Whether the variable is the `profiledone` or `routedone` of the state that calls.
  [[nodiscard]] bool isDone(VariableId variable) const {
    const State& state = m_.states[state_];
    return variable == state.profile.done || variable == state.route.done;
  }

  /// Whether the condition, true at the call, is certainly true after it.
  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  [[nodiscard]] bool staysTrue(ExprId id) const {
    const Expr& e = m_[id];
    if (e.op == Op::And || e.op == Op::Or) {
      return staysTrue(e.operands[0]) && staysTrue(e.operands[1]);
    }
    return isPastATime(e) || isUnchanged(id);
  }

  /// `missiontime >= 2 h`, `20 min < statetime`.
  [[nodiscard]] bool isPastATime(const Expr& e) const {
    const bool greater = e.op == Op::Greater || e.op == Op::GreaterEqual;
    const bool less = e.op == Op::Less || e.op == Op::LessEqual;
    if (!greater && !less) {
      return false;
    }
    const ExprId clock = e.operands[greater ? 0 : 1];
    const ExprId time = e.operands[greater ? 1 : 0];
    return isGrowingClock(m_[clock].op) && isUnchanged(time);
  }

  /// Whether no case above certainly decides what happens after the return: their conditions are
  /// as false as at the call, or become true only at the mission's end, for which the called state
  /// does not wait.
  [[nodiscard]] bool nothingBefore(uint32_t number, StateId target) const {
    const auto& cases = m_.states[state_].cases;
    for (uint32_t c = 0; c < number; ++c) {
      const bool dead = v_.structure.moves[state_].dead[c] != Dead::No;
      const bool end = cases[c].transition == Transition::Exit && isPastATime(m_[cases[c].guard]) &&
                       !returnsByMissionTime(target);
      if (!dead && !end && !isUnchanged(cases[c].guard)) {
        return false;
      }
    }
    return true;
  }

  [[nodiscard]] bool returnsByMissionTime(StateId target) const {
    return std::ranges::any_of(m_[target].cases, [&](const Case& c) {
      return c.transition == Transition::Return &&
             anyIn(m_, c.guard, [](const Expr& e) { return e.op == Op::MissionTime; });
    });
  }

  [[nodiscard]] std::string hintFor(const Case& call) const {
    const std::string& name = m_[call.target].name;
    const Expr& guard = m_[call.guard];
    if (guard.op == Op::Variable && isDone(guard.variable)) {
      const bool profile = guard.variable == m_.states[state_].profile.done;
      const std::string word = profile ? "profiledone" : "routedone";
      return fmt::format("write `case {0} goto …`, or `case became({0}) call {1}` to call it once",
                         word, name);
    }
    const bool clock = anyIn(m_, call.guard, [](const Expr& e) { return isGrowingClock(e.op); });
    return fmt::format("write `became(…)` around the condition to call `{}` once{}", name,
                       clock ? ", or compare `resumetime`, which counts from the last return" : "");
  }

  Verification& v_;
  const Mission& m_;
  uint32_t state_ = 0;
  std::vector<bool> changed_;     ///< by variable
  std::vector<uint32_t> called_;  ///< the states that can be current until the return
};

}  // namespace

void passes::repeatedCalls(Verification& v) {
  RepeatedCalls(v).run();
}

}  // namespace glider::ir
