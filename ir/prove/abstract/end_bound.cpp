// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/end_bound.h"

#include "ir/core/ops.h"
#include "ir/core/walk.h"
#include "ir/prove/abstract/abstract_run.h"
#include "ir/prove/abstract/leaving.h"
#include "ir/prove/context/commands.h"
#include "ir/prove/context/control.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace glider::ir::prove {
namespace {

/// The upper bound of expressions evaluated, some tenths of a second: missions that count with
/// small numbers need far fewer.
constexpr size_t kMostEndWork = 4000000;

/// The latest time at which it becomes current, and how often that has been raised since it
/// passed a time that a guard names.
struct Arrival;
struct LatestArrival {
  double time = 0;
  unsigned raised = 0;
  const Arrival* from = nullptr;  ///< what it came from then; null: the start
};

/// Where a trace can be when a state becomes current.
struct Arrival {
  Control control;
  Valuation values;
  auto operator<=>(const Arrival&) const = default;
};

class EndSearch {
 public:
  EndSearch(const ProofContext& proof_context, double latest, Goal goal)
      : proof_context_(proof_context),
        m_(proof_context.mission),
        run_(proof_context),
        latest_(latest),
        goal_(goal),
        left_by_(proof_context.mission.states.size(), 0) {}

  EndBound end() {
    Control control;
    control.state = {0};
    Valuation values = run_.begin();
    run_.enter(control.state, nullptr, {}, values);
    first_ = arrive(control, std::move(values), 0);
    while (!pending_.empty()) {
      if (work_ > kMostEndWork || !follow()) {
        return {std::nullopt, {}, stays_, loop_};
      }
    }
    return {end_, left_by_};
  }

  /// After a bound was found.
  std::vector<Stay> stays() {
    std::vector<Stay> all;
    std::map<const Arrival*, size_t> numbers;
    for (const auto& [arrival, latest] : times_) {
      Valuation held;
      Leaving leaving = leavingFrom(arrival, latest.time, held);
      numbers.emplace(&arrival, all.size());
      all.push_back(
          {arrival.control, std::move(held), std::move(leaving.parts), {}, &arrival == first_});
    }
    for (const Followed& way : ways_) {
      all[numbers.at(way.from)].ways.push_back(
          {way.list, way.number,
           way.to == nullptr ? std::nullopt : std::optional(numbers.at(way.to))});
    }
    for (Stay& stay : all) {
      std::ranges::sort(stay.ways);
    }
    return all;
  }

 private:
  /// A way from one arrival to the next; both are keys of `times_`. To null: to the end.
  struct Followed {
    const Arrival* from;
    ListKind list;
    uint32_t number;
    const Arrival* to;
    auto operator<=>(const Followed&) const = default;
  };

  /// A variable of a state that `control` does not hold starts again before it is read, so it may
  /// be anything here. The arrival as it is kept; null if the goal is reached.
  const Arrival* arrive(const Control& control, Valuation values, double time) {
    if (goal_ == Goal::ExitOrSurface && commandsSurface(m_, m_[control.state])) {
      end_ = std::max(end_, time);
      return nullptr;
    }
    for (uint32_t i = 0; i < m_.variables.size(); ++i) {
      const Variable& variable = m_.variables[i];
      if (variable.owner.valid() && !control.holds(variable.owner)) {
        values[i] = anything(variable);
      }
    }
    Arrival arrival{control, std::move(values)};
    const auto [known, fresh] = times_.emplace(arrival, LatestArrival{time, 0});
    if (fresh || known->second.time < time) {
      raise(known->second, time);
      known->second.from = following_;
      pending_.push_back(std::move(arrival));
    }
    return &known->first;
  }

  /// A time that has been raised often is raised by a loop that only a condition of mission time
  /// can end: it becomes the next time that a condition names, or endless if there is none. A later
  /// time allows everything that an earlier one does.
  void raise(LatestArrival& latest, double time) {
    constexpr unsigned kOften = 20;
    const auto next = thresholds().lower_bound(time);
    const bool passed = next != thresholds().lower_bound(latest.time);
    latest = {time, passed ? 0 : latest.raised + 1, latest.from};
    if (latest.raised > kOften) {
      latest.time = next == thresholds().end() ? std::numeric_limits<double>::max() : *next;
    }
  }

  /// The mission times that guards name.
  const std::set<double>& thresholds() {
    if (!thresholds_) {
      thresholds_.emplace();
      const auto look = [&](const std::vector<Case>& cases) {
        for (const Case& c : cases) {
          forEachIn(m_, c.guard, [&](const Expr& e) { keepThreshold(e); });
        }
      };
      look(m_.always);
      for (const State& state : m_.states) {
        look(state.cases);
      }
    }
    return *thresholds_;
  }

  void keepThreshold(const Expr& e) {
    for (const auto& [clock, time] : {std::pair<size_t, size_t>{0, 1}, {1, 0}}) {
      if (isOrdering(e.op) && m_[e.operands.at(clock)].op == Op::MissionTime) {
        const Interval& x = proof_context_.intervals[e.operands.at(time).index];
        thresholds_->insert({x.lowest, x.highest});
      }
    }
  }

  /// `held`: the values that the variables may have until then.
  Leaving leavingFrom(const Arrival& from, double since, Valuation& held) const {
    held = from.values;
    forgetWhatStaysChange(m_[from.control.state], held);
    return leavingOf(proof_context_, m_[from.control.state], interrupting(from.control), held,
                     {0, since});
  }

  /// False if a trace may last longer than the given time.
  bool follow() {
    const Arrival from = std::move(pending_.back());
    pending_.pop_back();
    const auto known = times_.find(from);
    following_ = &known->first;
    Valuation held;
    const Leaving leaving = leavingFrom(from, known->second.time, held);
    work_ += leaving.work;
    if (leaving.by > latest_) {
      blame(from, held);
      return false;
    }
    double& left_by = left_by_[from.control.state.index];
    left_by = std::max(left_by, leaving.by);
    branch(from.control, ListKind::State, m_[from.control.state].cases, held, leaving.latest);
    if (leaving.interrupted >= 0) {
      const std::vector<double> any_time(m_.always.size(), leaving.interrupted);
      branch(from.control, ListKind::Always, m_.always, held, any_time);
    }
    return true;
  }

  /// Finds out why a trace may last so long: if the clocks bound every stay in this state, it is
  /// entered again and again.
  void blame(const Arrival& late, const Valuation& held) {
    const StateId state = late.control.state;
    const Interruptions always = interrupting(late.control);
    if (stayOf(proof_context_, m_[state], always, held).by > latest_) {
      stays_ = state;
      return;
    }
    std::vector<const Arrival*> way;
    for (const Arrival* at = following_; at != nullptr; at = times_.at(*at).from) {
      const auto before = std::ranges::find(way, at);
      if (before != way.end()) {
        std::set<StateId> states;
        std::for_each(before, way.end(),
                      [&](const Arrival* a) { states.insert(a->control.state); });
        loop_.assign(states.begin(), states.end());
        return;
      }
      way.push_back(at);
    }
  }

  /// Cases without a transition may fire on any tick.
  void forgetWhatStaysChange(const State& state, Valuation& values) const {
    for (const auto* cases : {&m_.always, &state.cases, &state.profile.cases, &state.route.cases}) {
      for (const Case& c : *cases) {
        if (staysIn(c.transition)) {
          run_.forget(c.action, values);
        }
      }
    }
    for (const Activity* activity : {&state.profile, &state.route}) {
      if (activity->done.valid()) {
        values[activity->done.index] = anything(m_[activity->done]);
      }
    }
  }

  [[nodiscard]] Interruptions interrupting(const Control& control) const {
    Interruptions found{{}, control.just_returned};
    for (uint32_t i = 0; i < m_.always.size(); ++i) {
      if (control.mayInterrupt(m_, i)) {
        found.cases.push_back(&m_.always[i]);
      }
    }
    return found;
  }

  static ClockRanges upTo(double time) {
    const Interval all{0, time, false};
    return {all, all, all};
  }

  void branch(const Control& control, ListKind list, const std::vector<Case>& cases,
              const Valuation& held, const std::vector<double>& latest) {
    if (cases.empty()) {
      return;
    }
    const AbstractEvaluator now(proof_context_, held, upTo(std::ranges::max(latest)));
    for (uint32_t i = 0; i < cases.size(); ++i) {
      if (list == ListKind::Always && !control.mayInterrupt(m_, i)) {
        continue;
      }
      const Truths& guard = now.truth(cases[i].guard);
      if (guard.is_true) {
        fire(control, list, i, cases[i], held, upTo(latest[i]));
      }
      if (guard.is_true && !guard.is_false && !guard.is_unknown) {
        break;  // it hides the rest
      }
    }
    work_ += now.work();
  }

  void fire(const Control& control, ListKind list, uint32_t number, const Case& c, Valuation values,
            const ClockRanges& clocks) {
    const double time = clocks.mission_time.highest;
    if (c.transition == Transition::Stay) {
      return;
    }
    if (c.transition == Transition::Exit) {
      end_ = std::max(end_, time);
      ways_.insert({following_, list, number, nullptr});
      return;
    }
    run_.execute(c.action, clocks, values);
    const Control after = control.moved(list, number, c);
    if (c.transition == Transition::Return) {
      run_.resume(after.state, clocks, values);
    } else {
      run_.enter(after.state, &c, clocks, values);
    }
    work_ +=
        run_.takeWork() + m_.variables.size() + 4 * after.stack.size();  // what it takes to keep
    ways_.insert({following_, list, number, arrive(after, std::move(values), time)});
  }

  const ProofContext& proof_context_;
  const Mission& m_;
  AbstractRun run_;
  double latest_;
  Goal goal_;
  StateId stays_;
  std::vector<StateId> loop_;
  const Arrival* following_ = nullptr;  ///< a key of `times_`
  std::vector<double> left_by_;         ///< of each state
  std::map<Arrival, LatestArrival> times_;
  std::set<Followed> ways_;
  const Arrival* first_ = nullptr;
  std::optional<std::set<double>> thresholds_;
  std::vector<Arrival> pending_;
  double end_ = 0;
  size_t work_ = 0;
};

}  // namespace

EndBound boundOf(const ProofContext& proof_context, double latest, Goal goal) {
  return EndSearch(proof_context, latest, goal).end();
}

std::vector<Stay> staysOf(const ProofContext& proof_context) {
  EndSearch search(proof_context, kLongestMission, Goal::Exit);
  return search.end().by ? search.stays() : std::vector<Stay>();
}

const EndBound& Ending::bound() {
  if (!bound_) {
    bound_ = boundOf(proof_context_, kLongestMission, Goal::Exit);
  }
  return *bound_;
}

const EndBound& Ending::boundWithoutPowerCuts() {
  if (!without_power_cuts_) {
    without_power_cuts_ = boundOf(proof_context_.withoutPowerCuts(), kLongestMission, Goal::Exit);
  }
  return *without_power_cuts_;
}

/// A search up to an earlier time takes the same path and ends at a state that is not left by then.
std::optional<double> Ending::by(double latest) {
  const EndBound& found = bound();
  if (!found.by && latest > kLongestMission) {
    return boundOf(proof_context_, latest, Goal::Exit).by;
  }
  return found.by && std::ranges::max(found.left_by) <= latest ? found.by : std::nullopt;
}

}  // namespace glider::ir::prove
