// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/earliest_entry.h"

#include "ir/core/walk.h"
#include "ir/prove/abstract/abstract_evaluator.h"
#include "ir/prove/abstract/watch_times.h"
#include "ir/verify/intervals.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <set>
#include <utility>

namespace glider::ir::prove {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Searches states in the order of the time at which they can first be entered: a state is never
/// entered earlier than the state that leads to it.
class EntrySearch {
 public:
  explicit EntrySearch(const ProofContext& proof_context)
      : proof_context_(proof_context),
        m_(proof_context.mission),
        entries_(m_.states.size(), kNever) {
    for (const Variable& variable : m_.variables) {
      values_.push_back(anything(variable));
    }
  }

  void run() {
    enter({0}, 0);
    while (!open_.empty()) {
      const auto [time, index] = open_.top();
      open_.pop();
      if (time == entries_[index]) {
        follow(m_.always, time);
        follow(m_.states[index].cases, time);
      }
    }
  }
  [[nodiscard]] const std::vector<double>& entries() const { return entries_; }
  [[nodiscard]] double exit() const { return exit_; }

 private:
  void enter(StateId state, double time) {
    if (time < entries_[state.index]) {
      entries_[state.index] = time;
      open_.emplace(time, state.index);
    }
  }

  /// Follows the cases of a state that is entered at `since` at the earliest.
  void follow(const std::vector<Case>& cases, double since) {
    for (const Case& c : cases) {
      const bool enters = c.transition == Transition::Goto || c.transition == Transition::Call;
      if (enters && since < entries_[c.target.index]) {
        enter(c.target, firstTrue(c.guard, since));
      } else if (c.transition == Transition::Exit && since < exit_) {
        exit_ = std::min(exit_, firstTrue(c.guard, since));
      }
    }
  }

  /// The greatest of the times in the guard before which it cannot be true.
  double firstTrue(ExprId guard, double since) {
    double first = since;
    for (const double time : timesOf(guard, since)) {
      if (mayBeTrue(guard, since, std::nextafter(time, 0))) {
        return first;
      }
      first = time;
    }
    return mayBeTrue(guard, since, kGreatestNumber) ? first : kNever;
  }

  /// Mission times at which a clock of the state has a value that the guard names.
  std::set<double> timesOf(ExprId guard, double since) const {
    std::set<double> times;
    forEachIn(m_, guard, [&](const Expr& e) {
      if (e.op == Op::Constant && e.type.dimension == support::dimension::time) {
        for (const double time : {e.number, since + e.number}) {
          if (time > since && time < kGreatestNumber) {
            times.insert(time);
          }
        }
      } else if (e.op == Op::Temporal) {
        const double time = since + timeNeeded(proof_context_, m_[e.temporal]);
        if (time > since && time < kGreatestNumber) {
          times.insert(time);
        }
      }
    });
    return times;
  }

  /// Whether the guard may be true at any mission time from `since` to `until`. The state may have
  /// been entered at any of them.
  bool mayBeTrue(ExprId guard, double since, double until) const {
    const Interval stay{0, until - since, false};
    // Windows that go on over a return began with an entry, not before `since` either.
    const IdleTemporals idle = idleBefore(proof_context_, guard, until - since, true);
    return AbstractEvaluator(proof_context_, values_, {{since, until, false}, stay, stay},
                             std::nullopt, &idle)
        .truth(guard)
        .is_true;
  }

  const ProofContext& proof_context_;
  const Mission& m_;
  Valuation values_;
  std::vector<double> entries_;
  double exit_ = kNever;
  using Entry = std::pair<double, uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

}  // namespace

std::vector<double> earliestEntries(const ProofContext& proof_context) {
  EntrySearch search(proof_context);
  search.run();
  return search.entries();
}

double earliestExit(const ProofContext& proof_context) {
  EntrySearch search(proof_context);
  search.run();
  return search.exit();
}

}  // namespace glider::ir::prove
