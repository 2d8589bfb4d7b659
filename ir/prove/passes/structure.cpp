// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The pass `structure`: what the structure lacks once the cases are gone that `guards` has proved
// never to fire (GL3001 to GL3004). In: Proof::dead; out: warnings of ir/verify that were not
// reported before. As exact as those checks (ir/README.md, "The checks").

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
