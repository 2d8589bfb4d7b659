// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The pass `requirements`: a verdict on each `require`: proved, refuted (GL3110) or undecided
// (GL3111). In: what all passes before have left, and the budget Proof::searches, which no other
// pass takes from. Out: Findings::requirements, with the trace, the premise, the assumptions and
// the evidence of each.
//
// The strategies of requirements/strategies.def are tried in order (RequirementCheck). Proofs are
// for an SBC whose power may be cut; a counterexample without power cuts is preferred. A mission
// with assumptions is checked with and without them, so that a proof names only those that it needs
// (Premises). README.md has the arguments.

#include "ir/prove/passes.h"
#include "ir/prove/requirements/requirement_check.h"

#include <algorithm>
#include <utility>

namespace glider::ir::prove {
namespace {

void checkWithoutAssumptions(Proof& proof) {
  StrategyContext context(proof);
  RequirementCheck(context).run();
}

void checkUnderAssumptions(Proof& proof) {
  const ProofContext proof_context(proof.worlds.assumed);
  Proof assuming{proof.context, proof.worlds,  proof_context,
                 proof.facts,   proof.options, proof.diagnostics};
  StrategyContext bare(proof);
  StrategyContext context(assuming, &bare);
  RequirementCheck(context).run();
  proof.findings.requirements = std::move(assuming.findings.requirements);
}

}  // namespace

void passes::requirements(Proof& proof) {
  const Mission& mission = proof.proof_context.mission;
  if (mission.requirements.empty()) {
    return;
  }
  if (mission.assumptions.empty()) {
    return checkWithoutAssumptions(proof);
  }
  const auto is_empty = [](const Sensor& sensor) { return sensor.lowest > sensor.highest; };
  if (std::ranges::any_of(proof.worlds.assumed.mission.sensors, is_empty) ||
      !proof.decided_assumptions.empty()) {
    return checkWithoutAssumptions(proof);  // GL3121 or GL3136 is reported: nothing rests on these
  }
  checkUnderAssumptions(proof);
}

}  // namespace glider::ir::prove
