// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Which assumptions a proof needs: the strategies prove it again under fewer of them.

#include "ir/prove/requirements/premises.h"

#include "ir/prove/evidence/needed_assumptions.h"

#include <algorithm>
#include <utility>

namespace glider::ir::prove {
namespace {

/// What naming only the needed assumptions may take, beside what the proofs take.
constexpr double kShareOfPremises = 0.25;

RepeatedProof provenByAny(const RequirementVerdict& was, StrategyContext& context) {
  for (const auto& [strategy, phase] : strategies()) {
    if (strategy.serves(context.mission.requirements[was.requirement])) {
      if (RepeatedProof again = strategy.provesAgain(was, context); again.proved) {
        return again;
      }
    }
  }
  return {};
}

}  // namespace

/// The world under some of the assumptions, and what is known of it.
class ContextUnderAssumptions {
 public:
  /// `plain`: without any.
  ContextUnderAssumptions(StrategyContext& plain, const std::vector<uint32_t>& kept)
      : world_(assuming(plain.proof.worlds.widest, kept)),
        proof_context_(world_),
        proof_{plain.proof.context, plain.proof.worlds,  proof_context_,
               plain.proof.facts,   plain.proof.options, plain.proof.diagnostics},
        context_(proof_, &plain) {}

  [[nodiscard]] StrategyContext& context() { return context_; }

 private:
  AssumedWorld world_;
  ProofContext proof_context_;
  Proof proof_;
  StrategyContext context_;
};

Premises::Premises(StrategyContext& context)
    : context_(context), budget_(budgetOf(context.proof.options, kShareOfPremises)) {}

void Premises::name(RequirementVerdict& proved, const Strategy& by) {
  const Mission& m = context_.mission;
  for (uint32_t i = 0; i < m.assumptions.size(); ++i) {
    if (by.mayRestOn(m.assumptions[i], m.requirements[proved.requirement])) {
      proved.assumptions.push_back(i);
    }
  }
  if (context_.proof.options.premises) {
    proved.assumptions = neededAssumptions(
        proved.assumptions, [&](const auto& fewer) { return isProvedUnder(fewer, proved); });
  }
}

/// A proof that is found again takes about as long as the first.
bool Premises::isProvedUnder(const std::vector<uint32_t>& fewer, RequirementVerdict& proved) {
  constexpr uint64_t kAtLeast = 50000;
  budget_.spend(Budget::kCondition * context_.mission.exprs.size());
  if (budget_.isUsedUp()) {
    return false;
  }
  const uint64_t effort =
      std::min<uint64_t>(uint64_t{StrategyContext::kLonger} * context_.proof.options.run_effort,
                         2 * proved.steps + kAtLeast);
  StrategyContext& context = under(fewer);
  const Budget before = std::exchange(context.proof.searches, budget_);
  const unsigned usual = std::exchange(context.search_effort, static_cast<unsigned>(effort));
  RepeatedProof again = provenByAny(proved, context);
  context.search_effort = usual;
  budget_ = std::exchange(context.proof.searches, before);
  if (!again.proved || (context_.wantsEvidence() && !again.evidence)) {
    return false;  // what evidence there is may rest on more
  }
  proved.evidence = std::move(again.evidence);
  return true;
}

StrategyContext& Premises::under(const std::vector<uint32_t>& some) {
  if (some.size() == context_.mission.assumptions.size()) {
    return context_;
  }
  // Not StrategyContext::bare for none of them: its mission still has what is assumed of the start,
  // for areas.
  std::shared_ptr<ContextUnderAssumptions>& found = under_some_[some];
  if (!found) {
    found = std::make_shared<ContextUnderAssumptions>(*context_.bare, some);
  }
  return found->context();
}

}  // namespace glider::ir::prove
