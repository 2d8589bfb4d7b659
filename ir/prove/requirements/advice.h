// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/context/proof_context.h"
#include "ir/prove/falsification/counterexample.h"
#include "support/diagnostics/engine.h"

/// Notes that say what to change where a requirement is not proved.
namespace glider::ir::prove {

/// Where the mission has no end bound of `seconds`, but would have one if each of its exits by
/// mission time were the first case of its list: names those that are not.
void noteLateExits(support::DiagnosticBuilder& warning, double seconds,
                   const ProofContext& proof_context);

/// Names each state that commands the surface and that `run` leaves under water, before the
/// slowest climb of the environment model is over.
void noteShortSurfacings(support::DiagnosticBuilder& error, const Counterexample& run,
                         const ProofContext& proof_context);

}  // namespace glider::ir::prove
