// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/prove.h"

#include "ir/prove/passes.h"

#include <utility>

namespace glider::ir::prove {

Findings prove(const Mission& mission, const platforms::Platform& platform, const Options& options,
               support::DiagnosticEngine& diagnostics) {
  const Ground ground(mission, platform);
  z3::config config;
  config.set("rlimit", static_cast<int>(options.run_effort));  // Spacer takes no other
  z3::context context(config);
  Proof proof{context, ground, options, diagnostics, {}, {}};
#define PASS(name, purpose) passes::name(proof);
#include "ir/prove/prove_passes.def"
#undef PASS
  return std::move(proof.findings);
}

}  // namespace glider::ir::prove
