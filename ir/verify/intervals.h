// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace glider::ir {

/// The greatest number that a variable, clock or reading can have; its negative is the least.
inline constexpr double kGreatestNumber = std::numeric_limits<double>::max();

/// The range of the known values of a number: finite, lowest <= highest; or empty, if it is never
/// known.
struct Interval {
  double lowest = 0;
  double highest = 0;
  bool empty = false;

  [[nodiscard]] bool within(double low, double high) const {
    return empty || (low <= lowest && highest <= high);
  }
};

/// The least interval that holds both.
Interval hull(const Interval& a, const Interval& b);

/// The interval of every expression of a valid mission; for a truth value it has no meaning.
/// Readings lie in their sensor's range, variables in theirs; nothing is assumed about how values
/// depend on each other. Bounds are computed with the mission's own arithmetic, in which every
/// operation is monotone, so they are exact where an operation is.
std::vector<Interval> intervalsOf(const Mission& mission);

/// The range of a variable or clock at some moment; none: as above.
using LeafRange = std::function<std::optional<Interval>(const Expr& leaf)>;
/// The same at a moment about which more is known.
std::vector<Interval> intervalsOf(const Mission& mission, const LeafRange& known);

/// The interval of another expression.
using OperandRange = std::function<const Interval&(uint32_t expression)>;
/// The interval of one expression, from those of the expressions that it reads: `operand` is asked
/// for its operands, and for what it watches if it is a window that `known` does not know.
Interval intervalOf(const Mission& mission, uint32_t expression, const LeafRange& known,
                    const OperandRange& operand);

/// Intervals of single expressions of a mission, for many questions about it.
class SubtreeIntervals {
 public:
  /// `narrow` may restrict the interval of each expression in the tree.
  using Narrow = std::function<Interval(uint32_t expression, const Interval&)>;
  /// `mission` outlives this.
  explicit SubtreeIntervals(const Mission& mission)
      : mission_(mission), all_(mission.exprs.size()) {}
  Interval of(ExprId root, const Narrow& narrow);

 private:
  const Mission& mission_;
  std::vector<Interval> all_;
};

}  // namespace glider::ir
