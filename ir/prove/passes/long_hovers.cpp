// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/hovers.h"
#include "ir/prove/context/duration_text.h"
#include "ir/prove/passes.h"
#include "support/diagnostics/catalogue.h"

#include <fmt/format.h>

namespace glider::ir::prove {

/// The usual samedepth_for of abend, s.
constexpr double kUsualSameDepth = 1800;

void passes::longHovers(Proof& proof) {
  if (proof.options.knows_abend) {
    return;
  }
  const ProofContext& proof_context = proof.proof_context;
  for (const LongHover& hover :
       prove::longHovers(proof_context, proof.ending.boundWithoutPowerCuts())) {
    if (hover.certain_s > kUsualSameDepth) {
      const State& state = proof_context.mission[hover.state];
      proof.diagnostics.report(support::DiagnosticId::hoversLong, state.range, state.name,
                               fmt::format("{:.4g} m", hover.depth_m), durationOf(kUsualSameDepth));
    }
  }
}

}  // namespace glider::ir::prove
