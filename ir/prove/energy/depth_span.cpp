// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/energy/depth_span.h"

#include <algorithm>

namespace glider::ir::prove {

double gapBetween(const DepthSpan& a, const DepthSpan& b) {
  return std::max({0.0, a.shallowest - b.deepest, b.shallowest - a.deepest});
}

std::optional<DepthSpan> depthsWhere(const ProofContext& proof_context, const Valuation& values,
                                     const ClockRanges& clocks, ExprId guard) {
  if (!proof_context.depth) {
    return DepthSpan{};
  }
  const Interval& all = proof_context.sensors[proof_context.depth->index];
  const auto mayBeTrue = [&](double lowest, double highest) {
    const AssumedReading reading{*proof_context.depth, {lowest, highest, lowest > highest}};
    return AbstractEvaluator(proof_context, values, clocks, reading).truth(guard).is_true;
  };
  if (all.empty || !mayBeTrue(all.lowest, all.highest)) {
    return std::nullopt;
  }
  const double range = all.highest - all.lowest;
  const double least = all.lowest + leastWhere(range, [&](double x) {
                         return mayBeTrue(all.lowest, all.lowest + x);
                       });
  const double most = all.highest - leastWhere(range, [&](double x) {
                        return mayBeTrue(all.highest - x, all.highest);
                      });
  const double apart = proof_context.platformSensor(*proof_context.depth)->noise / 2;
  return DepthSpan{std::max(0.0, least - apart), most + apart};
}

}  // namespace glider::ir::prove
