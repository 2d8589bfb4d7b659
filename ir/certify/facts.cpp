// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Rounding to nearest is monotone, and so is settling: the ends of an interval, computed as the
// machine computes, bound what the machine gets for what lies between.

#include "ir/certify/facts.h"

#include "ir/core/ops.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace glider::ir::certify {
namespace {

constexpr double kPi = 3.1415926536;  // rounded up
/// More than runtime/numbers is ever wrong by, relative to the ends of a function's range.
constexpr double kSlack = 1e-9;
constexpr double kHalfEarth = 2.1e7;  ///< m; no distance on the sphere is greater
/// More than the sums of a window's mean are ever wrong by, relative to its readings: at most 258
/// bins.
constexpr double kMeanSlack = 0x1p-40;

Range between(double lowest, double highest) {
  const bool fits = std::fabs(lowest) <= kLargest && std::fabs(highest) <= kLargest;
  return {std::clamp(lowest, -kLargest, kLargest), std::clamp(highest, -kLargest, kLargest), !fits};
}

/// N3.
double settle(double value) {
  return std::fabs(value) <= kTiny ? 0 : value;
}

/// Of results that settle.
Range results(double lowest, double highest) {
  return between(settle(lowest), settle(highest));
}

Range anything() {
  return {-kLargest, kLargest, true};
}

Range hull(std::initializer_list<double> corners) {
  return results(std::min(corners), std::max(corners));
}

Range quotient(const Range& a, const Range& b) {
  if (b.lowest <= 0 && b.highest >= 0) {
    return anything();
  }
  return hull(
      {a.lowest / b.lowest, a.lowest / b.highest, a.highest / b.lowest, a.highest / b.highest});
}

Range binary(BinaryOp op, const Range& a, const Range& b) {
  switch (op) {
    case BinaryOp::Add:
      return results(a.lowest + b.lowest, a.highest + b.highest);
    case BinaryOp::Subtract:
      return results(a.lowest - b.highest, a.highest - b.lowest);
    case BinaryOp::Multiply:
      return hull(
          {a.lowest * b.lowest, a.lowest * b.highest, a.highest * b.lowest, a.highest * b.highest});
    case BinaryOp::Divide:
      return quotient(a, b);
    case BinaryOp::Min:
      return {std::min(a.lowest, b.lowest), std::min(a.highest, b.highest)};
    case BinaryOp::Max:
      return {std::max(a.lowest, b.lowest), std::max(a.highest, b.highest)};
  }
  return anything();
}

Range unary(UnaryOp op, const Range& a) {
  switch (op) {
    case UnaryOp::Negate:
      return {-a.highest, -a.lowest};
    case UnaryOp::Abs:
      return {
          a.lowest <= 0 && a.highest >= 0 ? 0 : std::min(std::fabs(a.lowest), std::fabs(a.highest)),
          a.magnitude()};
    case UnaryOp::Sqrt:
      return {std::sqrt(std::max(a.lowest, 0.0)), std::sqrt(std::max(a.highest, 0.0)), true};
  }
  return anything();
}

/// N12; ops.def says in which range.
Range function(FunctionOp op) {
  switch (op) {
    case FunctionOp::Sin:
    case FunctionOp::Cos:
      return {-1 - kSlack, 1 + kSlack, true};
    case FunctionOp::Atan2:
      return {-kPi, kPi, true};
    case FunctionOp::Distance:
      return {0, kHalfEarth, true};
    case FunctionOp::Bearing:
      return {0, 2 * kPi, true};
    case FunctionOp::Salinity:
      return {0, 45, true};
    case FunctionOp::Density:
      return {950, 1150, true};
    case FunctionOp::OffsetLatitude:
      return {-90, 90, true};
    case FunctionOp::OffsetLongitude:
      return {-180, 180, true};
    case FunctionOp::Tan:
    case FunctionOp::Remainder:
      break;
  }
  return anything();
}

/// N5, in each of its three cases.
Range clamp(const Range& x, const Range& l, const Range& h) {
  return {std::min(std::max(x.lowest, l.lowest), h.lowest),
          std::max(std::min(x.highest, h.highest), l.highest)};
}

Range rangeOf(const Mission& mission, const Expr& e, const Facts& facts) {
  const auto of = [&](size_t i) -> const Range& { return facts.ranges[e.operands.at(i).index]; };
  switch (groupOf(e.op)) {
    case OpGroup::Constant:
      return {e.number, e.number};
    case OpGroup::Sensor:
      return rangeOfReadings(mission[e.sensor]);
    case OpGroup::Clock:
    case OpGroup::Age:
      return {0, kLastSecond};
    case OpGroup::Variable:
      return facts.declared[e.variable.index];
    case OpGroup::Temporal:
      return isWindow(mission[e.temporal].kind)
                 ? windowRange(mission[e.temporal].kind,
                               facts.ranges[mission[e.temporal].operand.index])
                 : Range{};
    case OpGroup::Unary:
      return unary(opIn<UnaryOp>(e.op), of(0));
    case OpGroup::Binary:
      return binary(opIn<BinaryOp>(e.op), of(0), of(1));
    case OpGroup::Function:
      return function(opIn<FunctionOp>(e.op));
    case OpGroup::Clamp:
      return clamp(of(0), of(1), of(2));
    case OpGroup::Select:
      return {std::min(of(1).lowest, of(2).lowest), std::max(of(1).highest, of(2).highest)};
    case OpGroup::Element: {
      const auto [least, greatest] = std::ranges::minmax(mission[e.table].values);
      return {least, greatest};
    }
    case OpGroup::Call:
      return between(mission[e.use].lowest, mission[e.use].highest);
    case OpGroup::Truth:
    case OpGroup::Comparison:
    case OpGroup::Known:
    case OpGroup::Logic:
      break;
  }
  return {};
}

/// Whether a known value is a whole number. A sum or product of whole numbers is one even when it
/// is rounded: from 2^53 on, every double is.
bool isWhole(const Mission& mission, const Expr& e, const Facts& facts) {
  const auto of = [&](size_t i) { return facts.whole[e.operands.at(i).index]; };
  const auto whole = [](double x) { return std::floor(x) == x; };
  switch (groupOf(e.op)) {
    case OpGroup::Constant:
      return whole(e.number);
    case OpGroup::Variable:
      return facts.whole_variable[e.variable.index];
    case OpGroup::Unary:
      return e.op != Op::Sqrt && of(0);
    case OpGroup::Binary:
      return e.op != Op::Divide && of(0) && of(1);
    case OpGroup::Clamp:
      return of(0) && of(1) && of(2);
    case OpGroup::Select:
      return of(1) && of(2);
    case OpGroup::Element:
      return std::ranges::all_of(mission[e.table].values, whole);
    case OpGroup::Truth:
    case OpGroup::Sensor:
    case OpGroup::Clock:
    case OpGroup::Temporal:
    case OpGroup::Age:
    case OpGroup::Function:
    case OpGroup::Call:
    case OpGroup::Comparison:
    case OpGroup::Known:
    case OpGroup::Logic:
      break;
  }
  return false;
}

/// A variable and what it may be given.
struct Assignment {
  VariableId to;
  ExprId value;
};

std::vector<Assignment> assignmentsOf(const Mission& mission) {
  std::vector<Assignment> all;
  for (uint32_t i = 0; i < mission.variables.size(); ++i) {
    if (mission.variables[i].initial.valid()) {
      all.push_back({{i}, mission.variables[i].initial});
    }
  }
  for (const Block& block : mission.blocks) {
    for (const Statement& s : block.statements) {
      if (s.kind == StatementKind::Set) {
        all.push_back({s.variable, s.value});
      }
    }
  }
  const auto add = [&](const std::vector<Case>& cases) {
    for (const Case& c : cases) {
      for (size_t i = 0; i < c.arguments.size(); ++i) {
        all.push_back({mission[c.target].parameters.at(i), c.arguments[i]});
      }
    }
  };
  add(mission.always);
  for (const State& state : mission.states) {
    add(state.cases);  // those of activities go nowhere
  }
  return all;
}

/// The greatest set of variables that only whole numbers are ever assigned to. A parameter is given
/// at launch, and so may be any number.
void findWhole(const Mission& mission, Facts& facts) {
  for (const Variable& v : mission.variables) {
    facts.whole_variable.push_back(v.kind != VariableKind::Parameter &&
                                   v.type.kind == TypeKind::Quantity);
  }
  const std::vector<Assignment> assignments = assignmentsOf(mission);
  for (bool changed = true; changed;) {
    changed = false;
    facts.whole.clear();
    for (const Expr& e : mission.exprs) {
      facts.whole.push_back(isWhole(mission, e, facts));
    }
    for (const Assignment& a : assignments) {
      if (facts.whole_variable[a.to.index] && !facts.whole[a.value.index]) {
        facts.whole_variable[a.to.index] = false;
        changed = true;
      }
    }
  }
}

bool isOnGrid(const Expr& e, const std::vector<bool>& variables) {
  return groupOf(e.op) == OpGroup::Clock || (e.op == Op::Constant && e.number == 0) ||
         (e.op == Op::Variable && variables[e.variable.index]);
}

/// Variables that only ever get the mission time, 0 or one another, and nothing at launch.
void findClockGrid(const Mission& mission, Facts& facts) {
  std::vector<bool> variables;
  for (const Variable& v : mission.variables) {
    variables.push_back(v.kind != VariableKind::Parameter && v.type.kind == TypeKind::Quantity);
  }
  const std::vector<Assignment> assignments = assignmentsOf(mission);
  for (bool changed = true; changed;) {
    changed = false;
    for (const Assignment& a : assignments) {
      const Expr& value = mission[a.value];
      const bool keeps = value.op == Op::MissionTime ||
                         (groupOf(value.op) != OpGroup::Clock && isOnGrid(value, variables));
      if (variables[a.to.index] && !keeps) {
        variables[a.to.index] = false;
        changed = true;
      }
    }
  }
  for (const Expr& e : mission.exprs) {
    facts.on_clock_grid.push_back(isOnGrid(e, variables));
  }
}

/// D1: degrees of a raw value without its sign; 60 minutes or more, which are unknown, count as 60.
double degrees(double magnitude) {
  const double minutes = std::fmod(magnitude, 100);
  return (magnitude - minutes) / 100 + std::min(minutes, 60.0) / 60;
}

}  // namespace

double Range::magnitude() const {
  return std::max(std::fabs(lowest), std::fabs(highest));
}

Range rangeOfReadings(const Sensor& s) {
  if (s.encoding == Encoding::DegreesMinutes) {
    return hull({std::copysign(degrees(std::fabs(s.lowest)), s.lowest),
                 std::copysign(degrees(std::fabs(s.highest)), s.highest)});
  }
  return hull({s.lowest * s.to_si, s.highest * s.to_si});
}

Range windowRange(TemporalKind kind, const Range& of) {
  const double slack = kMeanSlack * of.magnitude();
  switch (kind) {
    case TemporalKind::Mean:
      return results(of.lowest - slack, of.highest + slack);
    case TemporalKind::Lowest:
    case TemporalKind::Highest:
    case TemporalKind::AtLowest:
    case TemporalKind::AtHighest:
      return of;
    case TemporalKind::Number:
      return between(0, kLargest);
    case TemporalKind::Spread:
      return results(0, of.highest - of.lowest);
    case TemporalKind::Slope:
    case TemporalKind::Steepest:
    case TemporalKind::AtSteepest:
    case TemporalKind::Became:
    case TemporalKind::Held:
      break;
  }
  return anything();
}

Facts factsOf(const Mission& mission) {
  Facts facts;
  for (const Variable& v : mission.variables) {
    facts.declared.push_back(between(v.lowest, v.highest));
  }
  for (const Expr& e : mission.exprs) {
    facts.ranges.push_back(rangeOf(mission, e, facts));
  }
  findWhole(mission, facts);
  findClockGrid(mission, facts);
  return facts;
}

}  // namespace glider::ir::certify
