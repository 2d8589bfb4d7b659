// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/eval/interpreter.h"
#include "ir/verify/guarded_ranges.h"
#include "ir/verify/intervals.h"
#include "ir/verify/passes.h"
#include "ir/verify/value_text.h"
#include "ir/verify/whole_numbers.h"
#include "support/diagnostics/ids/verification.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace glider::ir {
namespace {

using support::DiagnosticId;

/// A greater bound means that there is none.
constexpr double kNoBound = 1e300;

/// A value of the interval that is outside the variable's range.
std::string outside(const Interval& x, const Variable& v) {
  const double end = x.highest > v.highest ? x.highest : x.lowest;
  if (std::fabs(end) > kNoBound) {
    return "any value";
  }
  const std::string text = withUnit(end, v.type);
  const bool above = x.highest > v.highest;
  const bool rounding = text == withUnit(above ? v.highest : v.lowest, v.type);
  return rounding ? fmt::format("a little {} than {} by rounding", above ? "more" : "less", text)
                  : text;
}

class RangeCheck {
 public:
  explicit RangeCheck(Verification& verification)
      : v_(verification),
        m_(verification.structure.mission),
        intervals_(intervalsOf(verification.structure.mission)) {
    countRemainders();
  }

  void run() {
    bool defaults_fit = true;
    for (const Variable& v : m_.variables) {
      if (!v.initial.valid() || fits(v, v.initial)) {
        continue;
      }
      const bool parameter = v.kind == VariableKind::Parameter;
      defaults_fit &= !parameter;
      report(
          parameter ? support::diagnostics::parameterDefault : support::diagnostics::initialRange,
          v.range, v, v.initial);
    }
    if (defaults_fit) {
      conditions();
    }
    if (!doubtful().empty()) {
      kept_ = keptByGuards(m_, intervals_, doubtful_);
      assignments();
    }
  }

 private:
  /// A remainder is below its divisor; of whole numbers it is at most one below.
  void countRemainders() {
    if (std::ranges::find(m_.exprs, Op::Remainder, &Expr::op) == m_.exprs.end()) {
      return;  // few missions have one, and what is whole is a fixpoint over the mission
    }
    const std::vector<bool> whole = wholeExpressions(m_, intervals_);
    for (size_t i = 0; i < m_.exprs.size(); ++i) {
      if (m_.exprs[i].op == Op::Remainder && whole[i] && intervals_[i].highest >= 1) {
        intervals_[i].highest -= 1;
      }
    }
  }

  [[nodiscard]] bool fits(const Variable& v, ExprId value) const {
    return v.type.kind == TypeKind::Bool || intervals_[value.index].within(v.lowest, v.highest);
  }

  void report(DiagnosticId id, support::SourceRange range, const Variable& v, ExprId value) {
    v_.diagnostics.report(id, range, v.name, outside(intervals_[value.index], v), rangeText(v),
                          withUnit(v.lowest, v.type), withUnit(v.highest, v.type));
  }

  /// Assignments that only their guards may keep in range.
  const std::set<AssignmentPlace>& doubtful() {
    for (const Block& block : m_.blocks) {
      for (size_t i = 0; i < block.statements.size(); ++i) {
        const Statement& s = block.statements[i];
        if (s.kind == StatementKind::Set && !fits(m_[s.variable], s.value)) {
          doubtful_.emplace(&block, i);
        }
      }
    }
    arguments(m_.always);
    for (const State& s : m_.states) {
      arguments(s.cases);
    }
    return doubtful_;
  }

  void arguments(const std::vector<Case>& cases) {
    for (const Case& c : cases) {
      for (size_t i = 0; i < c.arguments.size(); ++i) {
        if (!fits(m_[m_[c.target].parameters[i]], c.arguments[i])) {
          doubtful_.emplace(&c, i);
        }
      }
    }
  }

  void assignments() {
    for (const Block& block : m_.blocks) {
      for (size_t i = 0; i < block.statements.size(); ++i) {
        const Statement& s = block.statements[i];
        if (leaves({&block, i}) && firstOfArray(s)) {
          report(support::diagnostics::assignmentRange, s.range, m_[s.variable], s.value);
        }
      }
    }
    reportArguments(m_.always);
    for (const State& s : m_.states) {
      reportArguments(s.cases);
    }
  }

  /// False for a statement of the text that was reported for another element of the same array.
  bool firstOfArray(const Statement& s) {
    const std::string& name = m_[s.variable].name;
    return told_.emplace(s.range.file, s.range.begin, name.substr(0, name.find('['))).second;
  }

  [[nodiscard]] bool leaves(const AssignmentPlace& place) const {
    return doubtful_.contains(place) && !kept_.contains(place);
  }

  void conditions() {
    if (const auto failed = failedCondition(m_, defaultParameters(m_))) {
      v_.diagnostics.report(support::diagnostics::conditionUnmet, m_[m_.conditions[*failed]].range);
    }
  }

  void reportArguments(const std::vector<Case>& cases) {
    for (const Case& c : cases) {
      for (size_t i = 0; i < c.arguments.size(); ++i) {
        if (leaves({&c, i})) {
          report(support::diagnostics::argumentRange, c.range, m_[m_[c.target].parameters[i]],
                 c.arguments[i]);
        }
      }
    }
  }

  Verification& v_;
  const Mission& m_;
  std::vector<Interval> intervals_;
  std::set<AssignmentPlace> doubtful_;
  std::set<AssignmentPlace> kept_;  ///< those of them that their guards keep in range
  std::set<std::tuple<uint32_t, uint32_t, std::string>> told_;
};

}  // namespace

void passes::ranges(Verification& v) {
  RangeCheck(v).run();
}

}  // namespace glider::ir
