// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/encoding/sampling.h"

#include "ir/core/ops.h"
#include "ir/eval/arithmetic.h"
#include "ir/eval/evaluate.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace glider::ir::prove {
namespace {

constexpr double kWithoutBound = 1e300;  // a range with this bound is unbounded
constexpr size_t kMostMoments = 256;
constexpr double kFarthestSample =
    1e6;  // far from what guards compare with; in seconds, later than all time-outs

/// A leaf that has one value in a moment: its operation, and the number of its sensor or variable.
using Leaf = std::pair<Op, uint32_t>;

Leaf leafOf(const Expr& e) {
  return {e.op, e.op == Op::Sensor     ? e.sensor.index
                : e.op == Op::Variable ? e.variable.index
                : e.op == Op::Temporal ? e.temporal.index
                                       : 0};
}

bool isClock(Op op) {
  return groupOf(op) == OpGroup::Clock;
}

/// The leaves of a guard, each with the values to try. `whole` is false if one of them cannot be
/// tried.
struct Guard {
  Evaluation evaluation;  ///< of the guard itself, which is tried many times
  std::map<Leaf, std::vector<double>> leaves = {};
  bool whole = true;
};

class Sampling {
 public:
  Sampling(const ProofContext& proof_context, const std::vector<Case>& cases)
      : proof_context_(proof_context),
        m_(proof_context.mission),
        cases_(cases),
        seen_(cases.size()) {}

  std::vector<SamplingResult> run() {
    for (size_t i = 0; i < cases_.size(); ++i) {
      guards_.push_back(guardOf(cases_[i].guard));
      // Leaves that the guard does not read are unknown or, if that is not sufficient, have a
      // general value.
      for (elsewhere_ = 0; guards_[i].whole && elsewhere_ < 2; ++elsewhere_) {
        tryGuard(i);
      }
    }
    return std::move(seen_);
  }

 private:
  Guard guardOf(ExprId root) {
    Guard guard{Evaluation(m_, root)};
    std::vector<ExprId> open = {root};
    std::vector<ExprId> done;
    while (!open.empty()) {
      const ExprId id = open.back();
      open.pop_back();
      if (std::ranges::find(done, id) != done.end()) {
        continue;
      }
      done.push_back(id);
      const Expr& e = m_[id];
      guard.whole =
          guard.whole && e.op != Op::Call && e.op != Op::Age && done.size() < kMostMoments;
      if (!guard.whole) {
        return guard;
      }
      if (isLeaf(e)) {
        guard.leaves.try_emplace(leafOf(e), generalValues(e));
      }
      if (e.op == Op::Temporal) {
        addWatched(m_[e.temporal], guard, open);
      }
      addThreshold(e, guard);
      for (uint32_t k = 0; k < operandCount(e); ++k) {
        open.push_back(e.operands.at(k));
      }
    }
    return guard;
  }

  static bool isLeaf(const Expr& e) {
    return e.op == Op::Sensor || e.op == Op::Variable || e.op == Op::Temporal || isClock(e.op);
  }

  static bool isWindow(const Temporal& temporal) { return ir::isWindow(temporal.kind); }

  /// The clock that is the upper bound of how long something has been watched.
  static Op clockOf(const Temporal& temporal) {
    return temporal.list == ListKind::Always     ? Op::MissionTime
           : temporal.kind == TemporalKind::Held ? Op::ResumeTime
                                                 : Op::StateTime;
  }

  /// Adds what a guard that looks back in time also depends on.
  static void addWatched(const Temporal& temporal, Guard& guard, std::vector<ExprId>& open) {
    guard.leaves.try_emplace({clockOf(temporal), 0}, std::vector<double>{0, kFarthestSample});
    for (const ExprId id : {temporal.operand, temporal.duration}) {
      if (id.valid() && !isWindow(temporal)) {
        open.push_back(id);
      }
    }
  }

  [[nodiscard]] Interval rangeOf(const Expr& e) const {
    if (e.op == Op::Sensor) {
      return proof_context_.sensors[e.sensor.index];
    }
    if (e.type.kind == TypeKind::Bool) {
      return {0, 1, false};
    }
    if (e.op == Op::Temporal) {
      return proof_context_.windows[e.temporal.index];
    }
    return e.op == Op::Variable ? Interval{m_[e.variable].lowest, m_[e.variable].highest, false}
                                : Interval{0, kWithoutBound, false};
  }

  /// First the value of the leaf where it does not matter, then values far from each other.
  [[nodiscard]] std::vector<double> generalValues(const Expr& e) const {
    const Interval range = rangeOf(e);
    const bool may_be_unknown =
        e.op == Op::Sensor || e.op == Op::Temporal ||
        (e.op == Op::Variable && !proof_context_.known.variables[e.variable.index]);
    std::vector<double> values;
    if (may_be_unknown || range.empty) {
      values.push_back(kUnknown);
    }
    if (range.empty) {
      return values;
    }
    values.push_back(std::clamp(0.0, range.lowest, range.highest));
    values.push_back(std::clamp(kFarthestSample, range.lowest, range.highest));
    values.push_back(std::clamp(-kFarthestSample, range.lowest, range.highest));
    return values;
  }

  /// A comparison of a leaf with a constant: values on both sides of it and at it.
  void addThreshold(const Expr& e, Guard& guard) const {
    if (!isComparison(e.op)) {
      return;
    }
    for (const size_t side : {0U, 1U}) {
      const Expr &leaf = m_[e.operands.at(side)], &other = m_[e.operands.at(1 - side)];
      const Interval range = rangeOf(leaf);
      if (!isLeaf(leaf) || other.op != Op::Constant || range.empty) {
        continue;
      }
      auto& values = guard.leaves.try_emplace(leafOf(leaf), generalValues(leaf)).first->second;
      const double step = std::fmax(1e-3, std::fabs(other.number) / 1024);
      for (const double value : {other.number + step, other.number - step, other.number}) {
        if (value >= range.lowest && value <= range.highest) {
          values.push_back(value);
        }
      }
    }
  }

  /// Tries all combinations of the values of the guard's leaves, until nothing more can be learnt.
  void tryGuard(size_t number) {
    const auto& leaves = guards_[number].leaves;
    std::vector<size_t> chosen(leaves.size(), 0);
    const SamplingResult& seen = seen_[number];
    for (size_t moment = 0; moment < kMostMoments && !(seen.first && seen.idle); ++moment) {
      size_t i = 0;
      values_.clear();
      for (const auto& [leaf, values] : leaves) {
        values_[leaf] = values[chosen[i++]];
      }
      look(number);
      if (!next(leaves, chosen)) {
        return;
      }
    }
  }

  static bool next(const std::map<Leaf, std::vector<double>>& leaves, std::vector<size_t>& chosen) {
    size_t i = 0;
    for (const auto& [leaf, values] : leaves) {
      if (++chosen[i] < values.size()) {
        return true;
      }
      chosen[i++] = 0;
    }
    return false;
  }

  void look(size_t number) {
    if (!isTrue(number)) {
      seen_[number].idle = true;
      return;
    }
    seen_[number].fires = true;
    bool first = true;
    for (size_t i = 0; i < number && first; ++i) {
      first = guards_[i].whole && !isTrue(i);
    }
    seen_[number].first = seen_[number].first || first;
  }

  [[nodiscard]] bool isTrue(size_t number) const {
    return std::get<Truth>(worth(guards_[number].evaluation)) == Truth::True;
  }

  [[nodiscard]] Value worth(ExprId id) const { return worth(Evaluation(m_, id)); }
  [[nodiscard]] Value worth(const Evaluation& evaluation) const {
    return evaluation([this](const Expr& e, std::span<const double>) {
      return isClock(e.op)          ? Value(clock(e.op))
             : e.op == Op::Temporal ? watched(e)
                                    : asValue(valueOf(e), e.type);
    });
  }

  /// A window is known only once its time has passed; `became` and `held` are true only while what
  /// they watch is true, and `held` only after its time.
  [[nodiscard]] Value watched(const Expr& e) const {
    const Temporal& temporal = m_[e.temporal];
    const double since = clock(clockOf(temporal));
    if (isWindow(temporal)) {
      const bool may_be_known = temporal.along.valid() || since >= temporal.length;
      return may_be_known ? valueOf(e) : kUnknown;
    }
    const Truth now = std::get<Truth>(worth(temporal.operand));
    const bool held = temporal.kind == TemporalKind::Held;
    const double duration = held ? std::get<double>(worth(temporal.duration)) : 0;
    if (now != Truth::True || !isKnown(duration)) {
      return now == Truth::True ? Truth::Unknown : now;
    }
    return truth(valueOf(e) == 1 && (!held || since >= duration));
  }

  [[nodiscard]] double valueOf(const Expr& e) const {
    const auto found = values_.find(leafOf(e));
    if (found != values_.end()) {
      return found->second;
    }
    const auto values = generalValues(e);
    return values[std::min(elsewhere_, values.size() - 1)];
  }

  /// Time since a state became current is part of the time in it, which is part of mission time.
  [[nodiscard]] double clock(Op op) const {
    double most = 0;
    for (const Op inner : {Op::ResumeTime, Op::StateTime, Op::MissionTime}) {
      const auto found = values_.find({inner, 0});
      most = found != values_.end() ? std::fmax(most, found->second) : most;
      if (inner == op) {
        break;
      }
    }
    return most;
  }

  const ProofContext& proof_context_;
  const Mission& m_;
  const std::vector<Case>& cases_;
  std::vector<Guard> guards_;
  std::map<Leaf, double> values_;  ///< of the current sample
  size_t elsewhere_ = 0;           ///< the general value that the other leaves have in it
  std::vector<SamplingResult> seen_;
};

}  // namespace

std::vector<SamplingResult> tryOut(const ProofContext& proof_context,
                                   const std::vector<Case>& cases) {
  return Sampling(proof_context, cases).run();
}

}  // namespace glider::ir::prove
