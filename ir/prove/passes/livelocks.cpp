// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The pass `livelocks`: states between which the clocks alone send a mission, tick after tick
// (GL3114). In: the times that conditions name, the cases that may fire, the earliest entry and the
// latest stay of each state. The mission is run on its clocks only; a guard counts only if it is
// true, or false, for any values of everything else. So a loop is real if the state is current at
// that time with an empty stack, which is not always so. No solver. Loops of more than four states
// are not found.

#include "ir/core/ops.h"
#include "ir/core/walk.h"
#include "ir/eval/arithmetic.h"
#include "ir/eval/evaluate.h"
#include "ir/prove/abstract/earliest_entry.h"
#include "ir/prove/context/control.h"
#include "ir/prove/context/duration_text.h"
#include "ir/prove/passes.h"
#include "support/check.h"
#include "support/diagnostics/ids/verification.h"
#include "support/listed.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace glider::ir::prove {
namespace {

/// The number of ticks that are followed: a round of up to four states is then seen twice.
constexpr size_t kTicks = 9;
/// The number of times of `always` that are checked in every state.
constexpr size_t kMostTimes = 64;

/// Where a mission is, with its clocks, s; NaN: a clock may be anything.
struct ClockedControl {
  Control control;
  double now = 0;
  std::vector<double> entered;  ///< of the waiting states, outermost first, then of the current
  double resumed = kUnknown;
};

/// Looks for states that the clocks alone make a mission alternate between, tick after tick: from a
/// state with an empty stack, at each time that its conditions name, by cases that must fire for
/// any values of sensors, variables and other clocks.
class LivelockCheck {
 public:
  explicit LivelockCheck(Proof& proof)
      : proof_(proof),
        m_(proof.proof_context.mission),
        cycle_s_(proof.proof_context.platform.envelope.cycle_s) {
    gatherTimes(m_.always, always_times_);
    if (always_times_.size() > kMostTimes) {
      always_times_.clear();
    }
    always_times_.insert(cycle_s_);
  }

  void run() {
    const Structure structure(m_, proof_.dead);
    for (uint32_t i = 0; i < m_.states.size(); ++i) {
      if (structure.at({i, Arrived::Free})) {
        look({i});
      }
    }
  }

 private:
  /// Checks the times that are named, and the first tick that the state can have if there is a
  /// livelock at an earlier one.
  void look(StateId state) {
    guards_.clear();  // of other states: most are not met again
    bool too_early = false;
    for (const double time : timesOf(state)) {
      if (lookAt(state, time, too_early)) {
        return;
      }
    }
    if (too_early && entryOf(state) < kLongestMission) {
      (void)lookAt(state, entryOf(state) + cycle_s_, too_early);
    }
  }

  /// Whether something is reported.
  bool lookAt(StateId state, double time, bool& too_early) {
    for (const double entered : {kUnknown, time - cycle_s_}) {
      Control control;
      control.state = state;
      const auto round = roundFrom({control, time, {entered}, entered});
      if (round.empty()) {
        continue;
      }
      if (isBeforeEntry(state, time, entered)) {
        too_early = true;
      } else if (isStillCurrent(state, time) && told_.insert(keyOf(round)).second) {
        tell(round, time);
        return true;
      }
    }
    return false;
  }

  /// Each time that the state's conditions, and those of `always`, compare mission time with, and
  /// the tick after it; and the first ticks of all.
  std::set<double> timesOf(StateId state) const {
    std::set<double> times = always_times_;
    gatherTimes(m_[state].cases, times);
    return times;
  }

  void gatherTimes(const std::vector<Case>& cases, std::set<double>& times) const {
    for (const Case& c : cases) {
      forEachIn(m_, c.guard, [&](const Expr& e) {
        if (e.op == Op::Constant && e.type.dimension == support::dimension::time && e.number > 0) {
          times.insert({e.number, e.number + cycle_s_});
        }
      });
    }
  }

  /// The states of the round that begins here and repeats, in their order; empty: none.
  std::vector<StateId> roundFrom(ClockedControl at) {
    std::vector<Control> met{at.control};
    while (met.size() < kTicks && step(at)) {
      met.push_back(at.control);
    }
    for (size_t length = 1; 2 * length < met.size(); ++length) {
      bool twice = true;
      for (size_t i = 0; i <= length; ++i) {
        twice = twice && isSame(met[i], met[i + length]);
      }
      if (twice) {
        std::vector<StateId> round;
        for (size_t i = 0; i < length; ++i) {
          round.push_back(met[i].state);
        }
        return round;
      }
    }
    return {};
  }

  static bool isSame(const Control& a, const Control& b) {
    return a.state == b.state && std::ranges::equal(a.stack, b.stack, {}, &Control::Waiting::state,
                                                    &Control::Waiting::state);
  }

  /// Makes a tick; false unless it certainly makes a transition.
  bool step(ClockedControl& at) {
    const bool own_first = at.control.just_returned;
    const auto& own = m_[at.control.state].cases;
    for (const bool always : {!own_first, own_first}) {
      const std::vector<Case>& cases = always ? m_.always : own;
      const auto fired = firstOf(cases, always, at);
      if (!fired.sure) {
        return false;
      }
      if (fired.number && cases[*fired.number].transition != Transition::Stay) {
        return move(at, always, *fired.number, cases[*fired.number]);
      }
    }
    return false;
  }

  struct Fired {
    bool sure = false;
    std::optional<uint32_t> number;  ///< none: no case fires
  };

  Fired firstOf(const std::vector<Case>& cases, bool always, const ClockedControl& at) {
    for (uint32_t i = 0; i < cases.size(); ++i) {
      if (always && !at.control.mayInterrupt(m_, i)) {
        continue;
      }
      const Truth guard = judge(cases[i].guard, at);
      if (guard != Truth::False) {
        return {guard == Truth::True, i};
      }
    }
    return {true, std::nullopt};
  }

  bool move(ClockedControl& at, bool always, uint32_t number, const Case& c) {
    if (c.transition == Transition::Exit ||
        (c.transition == Transition::Return && at.control.stack.empty())) {
      return false;
    }
    at.control = at.control.moved(always ? ListKind::Always : ListKind::State, number, c);
    if (c.transition == Transition::Return) {
      at.entered.pop_back();
    } else {
      if (c.transition == Transition::Goto) {
        at.entered.clear();
      }
      at.entered.push_back(at.now);
    }
    at.resumed = at.now;
    at.now += cycle_s_;
    return true;
  }

  /// The truth according to the clocks alone, for any other values; Unknown: either is possible.
  /// `known` would treat a missing value as false.
  Truth judge(ExprId guard, const ClockedControl& at) {
    const auto [known, added] = guards_.try_emplace(guard.index);
    if (added && !anyIn(m_, guard, [](const Expr& e) { return e.op == Op::Known; })) {
      known->second.emplace(m_, guard);
    }
    const std::optional<Evaluation>& evaluation = known->second;
    if (!evaluation) {
      return Truth::Unknown;
    }
    return std::get<Truth>((*evaluation)([&](const Expr& e, std::span<const double>) -> Value {
      return groupOf(e.op) == OpGroup::Clock ? clock(opIn<ClockOp>(e.op), at)
                                             : asValue(kUnknown, e.type);
    }));
  }

  static double clock(ClockOp op, const ClockedControl& at) {
    switch (op) {
      case ClockOp::MissionTime:
        return at.now;
      case ClockOp::StateTime:
        return at.now - at.entered.back();
      case ClockOp::ResumeTime:
        return at.now - at.resumed;
    }
    CHECK(false, "a clock without a meaning");
  }

  /// The earliest entry of the state, mission time, s; few missions need it.
  double entryOf(StateId state) {
    if (entries_.empty()) {
      entries_ = earliestEntries(proof_.proof_context);
    }
    return entries_[state.index];
  }

  /// Whether the state cannot have been entered at `entered`; NaN: at any time before `time`.
  bool isBeforeEntry(StateId state, double time, double entered) {
    return isKnown(entered) ? entered < entryOf(state) : time <= entryOf(state);
  }

  /// Whether the state may still be current at `time`, as far as is known.
  bool isStillCurrent(StateId state, double time) {
    const EndBound& end = proof_.ending.boundWithoutPowerCuts();
    return !end.by || time <= end.left_by[state.index];
  }

  static std::set<StateId> keyOf(const std::vector<StateId>& round) {
    return {round.begin(), round.end()};
  }

  void tell(const std::vector<StateId>& round, double time) {
    std::vector<std::string> names;
    for (const StateId state : round) {
      names.push_back(fmt::format("`{}`", m_[state].name));
    }
    if (names.size() == 1) {
      names.emplace_back("itself");
    }
    proof_.diagnostics.report(support::diagnostics::clockLivelock, m_[round.front()].range,
                              fmt::format("{:.6g} s", time), support::listed(names));
  }

  Proof& proof_;
  const Mission& m_;
  double cycle_s_;
  std::set<double> always_times_;
  std::vector<double> entries_;  ///< the earliest entry of every state, once it is needed
  std::set<std::set<StateId>> told_;
  /// How each guard is evaluated, which is done for many times; none if it asks what is known.
  std::unordered_map<uint32_t, std::optional<Evaluation>> guards_;
};

}  // namespace

void passes::livelocks(Proof& proof) {
  LivelockCheck(proof).run();
}

}  // namespace glider::ir::prove
