// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/context/budget.h"
#include "ir/prove/context/proof_context.h"
#include "ir/prove/prove.h"
#include "ir/prove/said_ranges.h"
#include "ir/verify/structure.h"
#include "ir/worlds/worlds.h"

#include <set>
#include <z3++.h>

namespace glider::ir::prove {

/// The checks of cases and commands get this share of what requirements may take, on top: neither
/// takes from the other, so no verdict on a requirement hangs on what else is checked.
inline constexpr double kShareOfChecks = 0.25;

inline Budget budgetOf(const Options& options, double share) {
  return Budget(static_cast<uint64_t>(share * static_cast<double>(options.total_effort)),
                options.until);
}

/// The data of a pass.
struct Proof {
  z3::context& context;
  const Worlds& worlds;
  const ProofContext& proof_context;  ///< of one of them
  const MissionFacts& facts;
  const Options& options;
  support::DiagnosticEngine& diagnostics;
  Budget checks = budgetOf(options, kShareOfChecks);  ///< of all passes but `requirements`
  Budget searches = budgetOf(options, 1);             ///< of `requirements`
  Ending ending{proof_context};
  Findings findings = {};
  std::set<CasePlace> dead = {};    ///< cases that were found never to fire
  std::set<CasePlace> hidden = {};  ///< those of them that earlier ones hide
  SaidRanges said = {};
  /// Numbers of assumptions about what the mission itself decides: no proof may rest on them.
  std::set<uint32_t> decided_assumptions = {};
};

namespace passes {
#define PASS(name, purpose) void name(Proof& proof);
#include "ir/prove/prove_passes.def"
#undef PASS
}  // namespace passes

}  // namespace glider::ir::prove
