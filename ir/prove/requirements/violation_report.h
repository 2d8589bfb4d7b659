// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/context/proof_context.h"
#include "ir/prove/falsification/counterexample.h"
#include "support/diagnostics/engine.h"

namespace glider::ir::prove {

/// Reports that `run` violates `requirement` (GL3110): when and how, what the mission does on the
/// way there, and each power cut.
void reportViolation(const Requirement& requirement, const Counterexample& run,
                     const ProofContext& proof_context, support::DiagnosticEngine& diagnostics);

}  // namespace glider::ir::prove
