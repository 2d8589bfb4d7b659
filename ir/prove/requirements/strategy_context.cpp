// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/requirements/strategy_context.h"

#include "ir/prove/abstract/state_depths.h"
#include "ir/prove/requirements/violation_report.h"

#include <algorithm>
#include <utility>

namespace glider::ir::prove {

StrategyContext::StrategyContext(Proof& of, StrategyContext* without)
    : proof(of),
      bare(without),
      mission(of.proof_context.mission),
      deepest(std::ranges::max(deepestByState(of.proof_context))),
      search_effort(of.options.run_effort) {}

Insight& StrategyContext::insight() {
  if (!insight_) {
    insight_.emplace(proof.proof_context, proof.ending.bound());
  }
  return *insight_;
}

Insight& StrategyContext::insightWithoutPowerCuts() {
  if (!powered_) {
    powered_.emplace(proof.proof_context.withoutPowerCuts(), proof.ending.boundWithoutPowerCuts());
  }
  return *powered_;
}

EvidenceBuilder& StrategyContext::evidences() {
  if (!evidences_) {
    evidences_.emplace(proof.proof_context, proof.ending.bound());
  }
  return *evidences_;
}

bool StrategyContext::powerCutsMatter() const {
  return proof.proof_context.tick_gap_s > proof.proof_context.platform.world.tick_gap_s;
}

std::string StrategyContext::limitReached() const {
  return proof.searches.isOver() ? "the time limit was reached (`--timeout`)"
                                 : "all requirements together reached their limit (`--effort`)";
}

RequirementVerdict refutedBy(Counterexample run, const Requirement& requirement,
                             const StrategyContext& context) {
  reportViolation(requirement, run, context.proof.proof_context, context.proof.diagnostics);
  return {0, Verdict::Refuted, std::move(run)};
}

}  // namespace glider::ir::prove
