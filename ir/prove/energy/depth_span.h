// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/abstract/abstract_evaluator.h"

#include <limits>
#include <optional>

namespace glider::ir::prove {

/// Depths of a vehicle, m.
struct DepthSpan {
  double shallowest = 0;
  double deepest = std::numeric_limits<double>::infinity();
};

/// How far apart two spans are, m; 0 if they meet.
double gapBetween(const DepthSpan& a, const DepthSpan& b);

/// Where the vehicle may be when `guard` is true and the depth is known: the readings for which it
/// may be, and their error. `values` are those of the variables, `clocks` those of the moment.
/// None: the guard is never true then.
std::optional<DepthSpan> depthsWhere(const ProofContext& proof_context, const Valuation& values,
                                     const ClockRanges& clocks, ExprId guard);

/// The least time for which a guard may be true: `mayBeTrue(t)` whether it may be at a time of at
/// most t, which no greater t makes false; `most` if not even then.
template <typename MayBeTrue>
double leastWhere(double most, MayBeTrue mayBeTrue) {
  if (mayBeTrue(0)) {
    return 0;
  }
  double not_yet = 0, may = most;
  constexpr int kHalvings = 40;
  for (int i = 0; i < kHalvings && may - not_yet > 1e-3; ++i) {
    const double middle = not_yet + (may - not_yet) / 2;
    (mayBeTrue(middle) ? may : not_yet) = middle;
  }
  return mayBeTrue(may) ? not_yet : most;
}

}  // namespace glider::ir::prove
