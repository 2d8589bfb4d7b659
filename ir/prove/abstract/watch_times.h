// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/abstract/abstract_evaluator.h"

namespace glider::ir::prove {

/// How long a `held` is not true, and a window over time not known, s: since its state was entered,
/// a `held` also since it was resumed (E3, E5, W9, B5, W6). 0: no time is needed.
double timeNeeded(const ProofContext& proof_context, const Temporal& temporal);

/// Those of states that `guard` reads and that need more than `seconds`; `windows`: also windows,
/// which go on while their state waits for a return. It takes no time for those of other guards.
IdleTemporals idleBefore(const ProofContext& proof_context, ExprId guard, double seconds,
                         bool windows);

}  // namespace glider::ir::prove
