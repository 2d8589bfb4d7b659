// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The pass `comparisons`: comparisons of a reading or a clock with a fixed value that have the same
// result for every reading (GL3113), usually because of a unit or a digit. In: the ranges of
// sensors, clocks and parameters. Out: warnings, except within what `guards` has already reported
// (Proof::said). Certain, as the ranges hold every known reading. Comparisons of computed values
// and of variables are left out, because their ranges are too wide or the pilot may mean it.

#include "ir/core/ops.h"
#include "ir/core/walk.h"
#include "ir/prove/abstract/abstract_evaluator.h"
#include "ir/prove/passes.h"
#include "support/diagnostics/ids/verification.h"

#include <map>
#include <optional>
#include <tuple>
#include <utility>

namespace glider::ir::prove {
namespace {

/// Looks for comparisons of a measured value with a value outside all that can be measured: errors
/// of a unit or a digit, in conditions that other parts keep alive. For a comparison in the text of
/// a behaviour, all uses must agree, because their arguments differ.
class ComparisonCheck {
 public:
  explicit ComparisonCheck(Proof& proof) : proof_(proof), m_(proof.proof_context.mission) {}

  void run() {
    const ClockRanges anytime{kAnytime, kAnytime, kAnytime};
    Valuation values;
    for (const Variable& variable : m_.variables) {
      values.push_back(anything(variable));
    }
    const AbstractEvaluator possible(proof_.proof_context, values, anytime);
    possible_ = &possible;
    look(m_.always);
    for (const State& state : m_.states) {
      look(state.cases);
      look(state.profile.cases);
      look(state.route.cases);
    }
    for (const Temporal& temporal : m_.temporals) {
      look(temporal.operand);
    }
    report();
  }

 private:
  static constexpr Interval kAnytime{0, 1e9, false};  ///< of clocks, s

  void look(const std::vector<Case>& cases) {
    for (const Case& c : cases) {
      look(c.guard);
    }
  }

  void look(ExprId root) {
    forEachIn(m_, root, [&](const Expr& e) {
      if (isOrdering(e.op) && !proof_.options.inLibrary(e.range) && isMeasured(e)) {
        note(e);
      }
    });
  }

  /// Whether a reading or a clock, unchanged, is compared with a value that is fixed when the
  /// mission is launched. A value computed from several readings is known too roughly, and a
  /// variable may be intended to switch the comparison off.
  [[nodiscard]] bool isMeasured(const Expr& e) const {
    return (isReading(m_[e.operands[0]]) && isFixed(e.operands[1])) ||
           (isFixed(e.operands[0]) && isReading(m_[e.operands[1]]));
  }

  static bool isReading(const Expr& e) {
    return e.op == Op::Sensor || groupOf(e.op) == OpGroup::Clock;
  }

  [[nodiscard]] bool isFixed(ExprId id) const {
    return !anyIn(m_, id, [&](const Expr& e) {
      const bool changes = e.op == Op::Variable && m_[e.variable].kind != VariableKind::Parameter;
      return changes || isReading(e) || e.op == Op::Temporal || e.op == Op::Age || e.op == Op::Call;
    });
  }

  void note(const Expr& e) {
    const auto id = ExprId{static_cast<uint32_t>(&e - m_.exprs.data())};
    const Truths& may = possible_->truth(id);
    std::optional<bool> always;
    if (may.is_true != may.is_false) {
      always = may.is_true;
    }
    const auto [at, first] = found_.try_emplace({e.range.file, e.range.begin, e.range.end},
                                                Found{e.range, always, isNegativeDepth(e)});
    if (!first && at->second.always != always) {
      at->second.always.reset();
    }
  }

  void report() {
    for (const auto& [place, found] : found_) {
      if (found.always && !proof_.said.cover(found.range)) {
        auto report = proof_.diagnostics.report(support::diagnostics::comparisonDecided,
                                                found.range, *found.always ? "true" : "false");
        if (found.negative_depth) {
          report.hint("depths are positive downwards: 20 m under the surface is `20 m`");
        }
      }
    }
  }

  /// Whether a depth is compared with a value above the surface.
  [[nodiscard]] bool isNegativeDepth(const Expr& e) const {
    const Expr& left = m_[e.operands[0]];
    const bool swapped = left.op != Op::Sensor;
    const Expr& reading = swapped ? m_[e.operands[1]] : left;
    if (reading.op != Op::Sensor || proof_.proof_context.depth != reading.sensor) {
      return false;
    }
    const Interval other = possible_->number(e.operands[swapped ? 0 : 1]);
    return other.highest < 0;
  }

  struct Found {
    support::SourceRange range;
    std::optional<bool> always;  ///< its constant value for every reading, in all uses
    bool negative_depth = false;
  };

  Proof& proof_;
  const Mission& m_;
  const AbstractEvaluator* possible_ = nullptr;
  std::map<std::tuple<uint32_t, uint32_t, uint32_t>, Found> found_;  ///< by place
};

}  // namespace

void passes::comparisons(Proof& proof) {
  ComparisonCheck(proof).run();
}

}  // namespace glider::ir::prove
