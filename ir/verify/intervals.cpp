// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/verify/intervals.h"

#include "ir/core/ops.h"
#include "ir/eval/arithmetic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

namespace glider::ir {

Interval hull(const Interval& a, const Interval& b) {
  if (a.empty || b.empty) {
    return a.empty ? b : a;
  }
  return {std::min(a.lowest, b.lowest), std::max(a.highest, b.highest), false};
}

namespace {

constexpr Interval kAny{-kGreatestNumber, kGreatestNumber, false};
constexpr Interval kNowhere{0, 0, true};
/// Half the circumference of a sphere of the Earth's mean radius (6371 km; IUGG), and a little
/// more.
constexpr double kFarthest = 2.0016e7;
/// Of runtime/numbers/seawater.cpp: the limits of its salinity, and of the density of any water
/// within its limits (kg/m3), with a margin.
constexpr double kMostSalinity = 45;
constexpr double kLeastDensity = 950;
constexpr double kMostDensity = 1150;

/// From `low` to `high` if some of it is finite; otherwise it is unknown.
Interval between(double low, double high) {
  const bool any = low <= high && low <= kGreatestNumber && high >= -kGreatestNumber;
  return any ? Interval{std::max(low, -kGreatestNumber), std::min(high, kGreatestNumber), false}
             : kNowhere;
}

/// The hull of an operation on the ends; an end that overflows becomes the greatest number.
template <typename Operation>
Interval ofEnds(const Interval& a, const Interval& b, Operation operation) {
  const std::array<double, 4> ends = {operation(a.lowest, b.lowest), operation(a.lowest, b.highest),
                                      operation(a.highest, b.lowest),
                                      operation(a.highest, b.highest)};
  return between(std::ranges::min(ends), std::ranges::max(ends));
}

/// A magnitude so small that it settles becomes 0.
Interval settled(Interval x) {
  x.lowest = settle(x.lowest);
  x.highest = settle(x.highest);
  return x;
}

Interval divided(const Interval& a, const Interval& b) {
  if (b.lowest <= 0 && b.highest >= 0) {
    return kAny;
  }
  return settled(ofEnds(a, b, [](double x, double y) { return x / y; }));
}

Interval magnitude(const Interval& x) {
  const double least =
      x.lowest <= 0 && x.highest >= 0 ? 0 : std::min(std::fabs(x.lowest), std::fabs(x.highest));
  return {least, std::max(std::fabs(x.lowest), std::fabs(x.highest)), false};
}

Interval root(const Interval& x) {
  return x.highest < 0 ? kNowhere
                       : Interval{std::sqrt(std::max(x.lowest, 0.0)), std::sqrt(x.highest), false};
}

/// x < l ? l : h < x ? h : x
Interval clamped(const Interval& x, const Interval& l, const Interval& h) {
  Interval result = between(std::max(x.lowest, l.lowest), std::min(x.highest, h.highest));
  if (x.lowest < l.highest) {
    result = hull(result, between(std::max(l.lowest, x.lowest), l.highest));
  }
  if (h.lowest < x.highest) {
    result = hull(result, between(h.lowest, std::min(h.highest, x.highest)));
  }
  return result;
}

/// The reading of ddmm.mmmm nearest to `raw` that has fewer than 60 minutes.
double degrees(double raw) {
  const double whole = std::floor(std::fabs(raw) / 100);
  const double minutes = std::fabs(raw) - 100 * whole;
  return std::copysign(whole + std::min(minutes, 60.0) / 60, raw);
}

Interval readings(const Sensor& s) {
  const Interval raw = between(s.lowest, s.highest);
  if (raw.empty) {
    return raw;
  }
  if (s.encoding == Encoding::DegreesMinutes) {
    return {degrees(raw.lowest), degrees(raw.highest), false};
  }
  const Interval factor{s.to_si, s.to_si, false};
  return settled(ofEnds(raw, factor, [](double x, double y) { return x * y; }));
}

class IntervalAnalysis {
 public:
  /// Both outlive this.
  IntervalAnalysis(const Mission& mission, const LeafRange& known, OperandRange all)
      : m_(mission), known_(known), all_(std::move(all)) {}

  /// The interval of one expression, when its operands have theirs.
  [[nodiscard]] Interval at(uint32_t index) const {
    const Expr& e = m_.exprs[index];
    return e.type.kind == TypeKind::Bool ? kAny : of(e);
  }

 private:
  [[nodiscard]] const Interval& operand(const Expr& e, size_t i) const {
    return all_(e.operands.at(i).index);
  }

  [[nodiscard]] Interval of(const Expr& e) const {
    if (opInfo(e.op).operands == 0 && e.op != Op::Call) {
      if (const auto known = known_(e)) {
        return *known;
      }
    }
    if (e.op != Op::Select && !haveOperands(e)) {
      return kNowhere;
    }
    const auto x = [&](size_t i) -> const Interval& { return operand(e, i); };
    switch (groupOf(e.op)) {
      case OpGroup::Constant:
        return {e.number, e.number, false};
      case OpGroup::Sensor:
        return readings(m_[e.sensor]);
      case OpGroup::Clock:
      case OpGroup::Age:
        return {0, kGreatestNumber, false};
      case OpGroup::Variable:
        return between(m_[e.variable].lowest, m_[e.variable].highest);
      case OpGroup::Temporal:
        return window(m_[e.temporal]);
      case OpGroup::Call:
        return between(m_[e.use].lowest, m_[e.use].highest);
      case OpGroup::Element:
        return elements(m_[e.table]);
      case OpGroup::Unary:
        return unary(opIn<UnaryOp>(e.op), x(0));
      case OpGroup::Binary:
        return binary(opIn<BinaryOp>(e.op), x(0), x(1));
      case OpGroup::Function:
        return function(e);
      case OpGroup::Select:
        return hull(x(1), x(2));
      case OpGroup::Clamp:
        return clamped(x(0), x(1), x(2));
      case OpGroup::Truth:
      case OpGroup::Comparison:
      case OpGroup::Known:
      case OpGroup::Logic:
        break;
    }
    return kAny;  // a truth value
  }

  /// Whether every operand can have a value. Those of a call do not matter.
  [[nodiscard]] bool haveOperands(const Expr& e) const {
    for (uint32_t i = 0; i < opInfo(e.op).operands; ++i) {
      if (operand(e, i).empty) {
        return false;
      }
    }
    return true;
  }

  static Interval elements(const Table& table) {
    const auto [lowest, highest] = std::ranges::minmax(table.values);
    return {lowest, highest, false};
  }

  /// A mean over a time is computed from sums that may round to outside the range of the readings.
  [[nodiscard]] Interval window(const Temporal& t) const {
    const Interval& x = all_(t.operand.index);
    switch (t.kind) {
      case TemporalKind::Lowest:
      case TemporalKind::Highest:
      case TemporalKind::AtLowest:
      case TemporalKind::AtHighest:
        return x;
      case TemporalKind::Number:
        return between(0, kAny.highest);
      case TemporalKind::Spread:
        return x.empty ? x : between(0, x.highest - x.lowest);
      case TemporalKind::Mean:
        return t.leg == Leg::None ? kAny : x;  // that of a leg is limited to its readings (Y6)
      case TemporalKind::Slope:
      case TemporalKind::Steepest:
      case TemporalKind::AtSteepest:
      case TemporalKind::Became:
      case TemporalKind::Held:
        break;
    }
    return kAny;
  }

  static Interval unary(UnaryOp op, const Interval& x) {
    switch (op) {
      case UnaryOp::Negate:
        return {-x.highest, -x.lowest, false};
      case UnaryOp::Abs:
        return magnitude(x);
      case UnaryOp::Sqrt:
        return root(x);
    }
    return kAny;
  }

  static Interval binary(BinaryOp op, const Interval& a, const Interval& b) {
    switch (op) {
      case BinaryOp::Add:
        return settled(between(a.lowest + b.lowest, a.highest + b.highest));
      case BinaryOp::Subtract:
        return settled(between(a.lowest - b.highest, a.highest - b.lowest));
      case BinaryOp::Multiply:
        return settled(ofEnds(a, b, [](double x, double y) { return x * y; }));
      case BinaryOp::Divide:
        return divided(a, b);
      case BinaryOp::Min:
        return {std::min(a.lowest, b.lowest), std::min(a.highest, b.highest), false};
      case BinaryOp::Max:
        return {std::max(a.lowest, b.lowest), std::max(a.highest, b.highest), false};
    }
    return kAny;
  }

  [[nodiscard]] Interval function(const Expr& e) const {
    switch (opIn<FunctionOp>(e.op)) {
      case FunctionOp::Sin:
      case FunctionOp::Cos:
        return {-1, 1, false};
      case FunctionOp::Tan:
        return kAny;
      case FunctionOp::Atan2:
        return {-std::numbers::pi, std::numbers::pi, false};
      case FunctionOp::Distance:
        return {0, kFarthest, false};
      case FunctionOp::Bearing:
        return {0, 2 * std::numbers::pi, false};
      case FunctionOp::Remainder:
        return {0, std::max(operand(e, 1).highest, 0.0), false};
      case FunctionOp::Salinity:
        return {0, kMostSalinity, false};
      case FunctionOp::Density:
        return {kLeastDensity, kMostDensity, false};
      case FunctionOp::OffsetLatitude:
        return {-90, 90, false};
      case FunctionOp::OffsetLongitude:
        return {-180, 180, false};
    }
    return kAny;
  }

  const Mission& m_;
  const LeafRange& known_;
  OperandRange all_;
};

std::optional<Interval> nothingMore(const Expr&) {
  return std::nullopt;
}

}  // namespace

std::vector<Interval> intervalsOf(const Mission& mission) {
  return intervalsOf(mission, nothingMore);
}

std::vector<Interval> intervalsOf(const Mission& mission, const LeafRange& known) {
  std::vector<Interval> all(mission.exprs.size());
  const IntervalAnalysis analysis(mission, known,
                                  [&](uint32_t i) -> const Interval& { return all[i]; });
  for (uint32_t i = 0; i < mission.exprs.size(); ++i) {
    all[i] = analysis.at(i);
  }
  return all;
}

Interval intervalOf(const Mission& mission, uint32_t expression, const LeafRange& known,
                    const OperandRange& operand) {
  return IntervalAnalysis(mission, known, operand).at(expression);
}

Interval SubtreeIntervals::of(ExprId root, const Narrow& narrow) {
  std::set<uint32_t> tree;
  std::vector<uint32_t> open{root.index};
  while (!open.empty()) {
    const uint32_t index = open.back();
    open.pop_back();
    if (!tree.insert(index).second) {
      continue;
    }
    const Expr& e = mission_.exprs[index];
    for (uint32_t k = 0; k < operandCount(e); ++k) {
      open.push_back(e.operands.at(k).index);
    }
  }
  const LeafRange known = nothingMore;
  const IntervalAnalysis analysis(mission_, known,
                                  [&](uint32_t i) -> const Interval& { return all_[i]; });
  for (const uint32_t index : tree) {  // operands before their users
    all_[index] = narrow(index, analysis.at(index));
  }
  return all_[root.index];
}

}  // namespace glider::ir
