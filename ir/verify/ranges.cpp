// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/eval/interpreter.h"
#include "ir/verify/intervals.h"
#include "ir/verify/passes.h"
#include "ir/verify/value_text.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace glider::ir {
namespace {

using support::DiagnosticId;

/// Beyond this a bound is no bound.
constexpr double kNoBound = 1e300;

/// A value of the interval that is outside the variable's range.
std::string outside(const Interval& x, const Variable& v) {
  const double end = x.highest > v.highest ? x.highest : x.lowest;
  return std::fabs(end) > kNoBound ? "any value" : withUnit(end, v.type);
}

class RangeCheck {
 public:
  explicit RangeCheck(Verification& verification)
      : v_(verification),
        m_(verification.structure.mission),
        intervals_(intervalsOf(verification.structure.mission)) {}

  void run() {
    bool defaults_fit = true;
    for (const Variable& v : m_.variables) {
      if (!v.initial.valid() || fits(v, v.initial)) {
        continue;
      }
      const bool parameter = v.kind == VariableKind::Parameter;
      defaults_fit &= !parameter;
      report(parameter ? DiagnosticId::parameterDefault : DiagnosticId::initialRange, v.range, v,
             v.initial);
    }
    if (defaults_fit) {
      conditions();
    }
    for (const Block& block : m_.blocks) {
      for (const Statement& s : block.statements) {
        if (s.kind == StatementKind::Set && !fits(m_[s.variable], s.value)) {
          report(DiagnosticId::assignmentRange, s.range, m_[s.variable], s.value);
        }
      }
    }
    arguments(m_.always);
    for (const State& s : m_.states) {
      arguments(s.cases);
    }
  }

 private:
  [[nodiscard]] bool fits(const Variable& v, ExprId value) const {
    return v.type.kind == TypeKind::Bool || intervals_[value.index].within(v.lowest, v.highest);
  }

  void report(DiagnosticId id, support::SourceRange range, const Variable& v, ExprId value) {
    v_.diagnostics.report(id, range, v.name, outside(intervals_[value.index], v), rangeText(v),
                          withUnit(v.lowest, v.type), withUnit(v.highest, v.type));
  }

  void conditions() {
    if (const auto failed = failedCondition(m_, defaultParameters(m_))) {
      v_.diagnostics.report(DiagnosticId::conditionUnmet, m_[m_.conditions[*failed]].range);
    }
  }

  void arguments(const std::vector<Case>& cases) {
    for (const Case& c : cases) {
      for (size_t i = 0; i < c.arguments.size(); ++i) {
        const Variable& v = m_[m_[c.target].parameters[i]];
        if (!fits(v, c.arguments[i])) {
          report(DiagnosticId::argumentRange, c.range, v, c.arguments[i]);
        }
      }
    }
  }

  Verification& v_;
  const Mission& m_;
  std::vector<Interval> intervals_;
};

}  // namespace

void passes::ranges(Verification& v) {
  RangeCheck(v).run();
}

}  // namespace glider::ir
