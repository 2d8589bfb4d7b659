// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/watch_times.h"

#include "ir/core/ops.h"
#include "ir/core/walk.h"

namespace glider::ir::prove {

double timeNeeded(const ProofContext& proof_context, const Temporal& temporal) {
  if (temporal.kind == TemporalKind::Held) {
    const Interval& duration = proof_context.intervals[temporal.duration.index];
    return duration.empty ? 0 : duration.lowest;
  }
  return isWindow(temporal.kind) && !temporal.along.valid() ? temporal.length : 0;
}

IdleTemporals idleBefore(const ProofContext& proof_context, ExprId guard, double seconds,
                         bool windows) {
  const Mission& m = proof_context.mission;
  IdleTemporals idle(m.temporals.size());
  forEachIn(m, guard, [&](const Expr& e) {
    if (e.op == Op::Temporal) {
      const Temporal& temporal = m[e.temporal];
      const bool counts =
          temporal.list != ListKind::Always && (windows || temporal.kind == TemporalKind::Held);
      idle[e.temporal.index] = counts && timeNeeded(proof_context, temporal) > seconds;
    }
  });
  return idle;
}

}  // namespace glider::ir::prove
