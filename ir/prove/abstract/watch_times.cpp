// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/watch_times.h"

#include "ir/core/ops.h"

namespace glider::ir::prove {

double timeNeeded(const ProofContext& proof_context, const Temporal& temporal) {
  if (temporal.kind == TemporalKind::Held) {
    const Interval& duration = proof_context.intervals[temporal.duration.index];
    return duration.empty ? 0 : duration.lowest;
  }
  return isWindow(temporal.kind) && !temporal.along.valid() ? temporal.length : 0;
}

IdleTemporals idleBefore(const ProofContext& proof_context, double seconds, bool windows) {
  IdleTemporals idle;
  for (const Temporal& temporal : proof_context.mission.temporals) {
    const bool counts =
        temporal.list != ListKind::Always && (windows || temporal.kind == TemporalKind::Held);
    idle.push_back(counts && timeNeeded(proof_context, temporal) > seconds);
  }
  return idle;
}

}  // namespace glider::ir::prove
