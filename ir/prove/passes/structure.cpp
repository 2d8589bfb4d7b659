// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/verify/structure.h"

#include "ir/prove/passes.h"
#include "ir/verify/passes.h"

#include <algorithm>

namespace glider::ir::prove {

/// Repeats the checks of ir/verify without the cases that the pass `guards` has found dead. What
/// was reported before is not reported again.
void passes::structure(Proof& proof) {
  if (proof.dead.empty()) {
    return;
  }
  const Structure structure(proof.proof_context.mission, proof.dead);
  support::DiagnosticEngine found;
  Verification verification{structure, found, {}};
  ir::passes::unreachableStates(verification);
  ir::passes::deadEnds(verification);
  ir::passes::missingExits(verification);
  const std::vector<support::Diagnostic> before = proof.diagnostics.sorted();
  for (const support::Diagnostic& diagnostic : found.sorted()) {
    const bool said = std::ranges::any_of(before, [&](const support::Diagnostic& earlier) {
      return earlier.id == diagnostic.id && earlier.range == diagnostic.range;
    });
    if (!said) {
      proof.diagnostics.add(diagnostic);
    }
  }
}

}  // namespace glider::ir::prove
