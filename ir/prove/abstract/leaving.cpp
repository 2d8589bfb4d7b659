// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/leaving.h"

#include "ir/core/ops.h"
#include "ir/core/walk.h"
#include "ir/prove/abstract/sum_at_most.h"
#include "ir/verify/intervals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>

namespace glider::ir::prove {
namespace {

class LeavingSearch {
 public:
  LeavingSearch(const ProofContext& proof_context, const State& state, const Interruptions& always,
                const Valuation& values, const IdleTemporals* idle = nullptr)
      : proof_context_(proof_context),
        m_(proof_context.mission),
        always_(always),
        values_(values),
        idle_(idle) {
    for (const Case& c : state.cases) {
      own_.push_back(&c);
    }
    const Interval all{0, kGreatestNumber, false};
    const AbstractEvaluator ever(proof_context, values, {all, all, all});
    for (const Cases* cases : {&always.cases, &std::as_const(own_)}) {
      for (const Case* c : *cases) {
        gather(c->guard, ever);
      }
    }
    work_ = ever.work();
  }

  /// The union over all parts of the time of arrival.
  Leaving leaving(const Arriving& arriving) const {
    Leaving all = none(-1);
    all.looks = 1;
    all.work = work_;
    for (const Arriving& part : split(arriving)) {
      const Leaving found = ofPart(part, part.latest);
      for (size_t i = 0; i < own_.size(); ++i) {
        all.latest[i] = std::max(all.latest[i], found.latest[i]);
      }
      all.by = std::max(all.by, found.by);
      all.parts.push_back({part, found.by, found.parts.front().at_once});
      all.interrupted = std::max(all.interrupted, found.interrupted);
      all.looks += found.looks;
      all.work += found.work;
    }
    return all;
  }

  /// For a mission time T that a guard names, a state that became current at s is left by
  /// max(s, T) + gap, after at most T + gap: the sum for s = 0. The other times do not depend on s.
  Leaving stay() const { return ofPart({0, kGreatestNumber}, 0); }

 private:
  /// With these as all times.
  [[nodiscard]] Leaving none(double time) const {
    return {time, std::vector<double>(own_.size(), time), time};
  }

  /// The parts that end at the times which the guards name; too many are not worth it. They meet,
  /// so that they also cover the real numbers between two doubles (ir/prove/evidence).
  [[nodiscard]] std::vector<Arriving> split(const Arriving& arriving) const {
    constexpr size_t kMostParts = 9;
    std::vector<Arriving> parts;
    double from = arriving.earliest;
    for (const double time : times_) {
      const bool within = time > from && time <= arriving.latest;
      if (within && std::isnormal(time) && times_.size() < kMostParts) {
        parts.push_back({from, time});
        from = time;
      }
    }
    parts.push_back({from, arriving.latest});
    return parts;
  }

  /// `since`: the latest time of arrival to count from.
  [[nodiscard]] Leaving ofPart(const Arriving& arriving, double since) const {
    const double gap = proof_context_.tick_gap_s;
    const double earliest = arriving.earliest;
    constexpr Interval kEver{0, kGreatestNumber, false};
    constexpr double kEndless = std::numeric_limits<double>::infinity();
    Leaving found = none(kEndless);
    // From `time` on, a certain case, or one before it, fires on every tick; `tick` is the latest
    // time of such a tick.
    const auto note = [&](double time, double tick, const ClockRanges& clocks) {
      ++found.looks;
      const AbstractEvaluator then(proof_context_, values_, clocks, std::nullopt, idle_);
      const size_t sure = firstSure(own_, then);
      for (size_t i = sure; i < own_.size(); ++i) {
        found.latest[i] = std::min(found.latest[i], i == sure ? tick : time);
      }
      const bool interrupted = firstSure(always_.cases, then) < always_.cases.size();
      for (double& latest : found.latest) {
        latest = interrupted && !always_.own_first ? std::min(latest, time) : latest;
      }
      found.by = sure < own_.size() || interrupted ? std::min(found.by, tick) : found.by;
      return std::pair(sure < own_.size(), std::move(then));
    };
    // From `time` on, some cases cannot be true.
    const auto until = [&](double time, const AbstractEvaluator& then) {
      for (size_t i = 0; i < own_.size(); ++i) {
        const bool over = !then.truth(own_[i]->guard).is_true;
        found.latest[i] = over ? std::min(found.latest[i], time) : found.latest[i];
      }
      found.work += then.work();
    };
    // What is certain on the first tick need not stay so: that tick leads away.
    const double last =
        arriving.latest >= kGreatestNumber ? kGreatestNumber : sumAtMost(arriving.latest, gap);
    const auto [at_once, first] =
        note(since, sumAtMost(since, gap), {{earliest, last, false}, kEver, {0, gap, false}});
    found.work += first.work();
    for (const double stay : stays_) {
      const Interval on{stay, kGreatestNumber,
                        false};  // the mission has flown for at least that long
      const double stayed = sumAtMost(since, stay);
      const ClockRanges then{{std::max(stay, earliest), kGreatestNumber, false}, on, on};
      until(stayed, note(stayed, sumAtMost(stayed, gap), then).second);
    }
    for (const double time : times_) {
      const ClockRanges then{{std::max(time, earliest), kGreatestNumber, false}, kEver, kEver};
      until(time, note(time, sumAtMost(std::max(since, time), gap), then).second);
    }
    for (double& latest : found.latest) {
      latest = std::min(latest, found.by);
    }
    // The state's own cases, if they come first, leave nothing to those of `always`.
    found.parts.push_back({arriving, found.by, at_once});
    found.interrupted = at_once && always_.own_first ? -1 : found.by;
    return found;
  }

  /// Times that the guards compare clocks with.
  void gather(ExprId root, const AbstractEvaluator& ever) {
    forEachIn(m_, root, [&](const Expr& e) {
      if (isOrdering(e.op)) {
        keep(e.operands[0], e.operands[1], ever);
        keep(e.operands[1], e.operands[0], ever);
      }
    });
  }

  void keep(ExprId clock, ExprId time, const AbstractEvaluator& ever) {
    const Op op = m_[clock].op;
    const Interval& x = ever.number(time);
    if (x.empty || x.highest >= kGreatestNumber || x.highest < 0) {
      return;
    }
    std::set<double>* kept = op == Op::MissionTime                         ? &times_
                             : op == Op::StateTime || op == Op::ResumeTime ? &stays_
                                                                           : nullptr;
    if (kept != nullptr) {
      kept->insert(x.highest);
      kept->insert(std::nextafter(x.highest, kGreatestNumber));  // the value after it
    }
  }

  /// The first case that leads away and must be true, with no case before it that may keep the
  /// state; the number of cases if there is none.
  static size_t firstSure(const Cases& cases, const AbstractEvaluator& then) {
    for (size_t i = 0; i < cases.size(); ++i) {
      const Truths& guard = then.truth(cases[i]->guard);
      if (guard.is_true && cases[i]->transition == Transition::Stay) {
        break;
      }
      if (guard.is_true && !guard.is_false && !guard.is_unknown) {
        return i;
      }
    }
    return cases.size();
  }

  const ProofContext& proof_context_;
  const Mission& m_;
  const Interruptions& always_;
  Cases own_;
  const Valuation& values_;
  const IdleTemporals* idle_;
  std::set<double> stays_{0};  ///< of the state's clocks, s
  std::set<double> times_;     ///< of mission time, s
  size_t work_ = 0;
};

}  // namespace

Leaving leavingOf(const ProofContext& proof_context, const State& state,
                  const Interruptions& always, const Valuation& values, const Arriving& arriving) {
  return LeavingSearch(proof_context, state, always, values).leaving(arriving);
}

Leaving stayOf(const ProofContext& proof_context, const State& state, const Interruptions& always,
               const Valuation& values, const IdleTemporals* idle) {
  return LeavingSearch(proof_context, state, always, values, idle).stay();
}

}  // namespace glider::ir::prove
