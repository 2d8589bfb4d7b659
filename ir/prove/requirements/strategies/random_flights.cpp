// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Two strategies: random flights without power cuts, whose violations are easier to understand, and
// with them. They can refute a requirement, and prove only that a state can be reached.

#include "ir/prove/requirements/random_trials.h"
#include "ir/prove/requirements/strategy.h"

#include <utility>

namespace glider::ir::prove {
namespace {

class RandomFlightsWithoutPowerCuts final : public Strategy {
 public:
  [[nodiscard]] bool serves(const Requirement& requirement) const override {
    return requirement.kind != RequirementKind::Reach;
  }

  std::optional<RequirementVerdict> judge(Attempt& attempt,
                                          StrategyContext& context) const override {
    if (!context.powerCutsMatter() || attempt.holds_without_power_cuts) {
      return std::nullopt;
    }
    const ProofContext powered = context.proof.proof_context.withoutPowerCuts();
    auto run = tryAtRandom(attempt.requirement, powered, context);
    return run ? std::optional(refutedBy(std::move(*run), attempt.requirement, context))
               : std::nullopt;
  }
};

class RandomFlights final : public Strategy {
 public:
  [[nodiscard]] bool serves(const Requirement&) const override { return true; }

  std::optional<RequirementVerdict> judge(Attempt& attempt,
                                          StrategyContext& context) const override {
    auto run = tryAtRandom(attempt.requirement, context.proof.proof_context, context);
    if (!run) {
      run = tryForLong(attempt.requirement, context.proof.proof_context, context);
    }
    if (!run) {
      return std::nullopt;
    }
    return attempt.requirement.kind == RequirementKind::Reach
               ? RequirementVerdict{attempt.number, Verdict::Proved, std::move(run)}
               : refutedBy(withoutUselessPowerCuts(std::move(*run), attempt, context),
                           attempt.requirement, context);
  }

  [[nodiscard]] std::optional<Evidence> evidence(const Requirement&, bool,
                                                 StrategyContext&) const override {
    return Evidence{Method::Run, {}};
  }

 private:
  /// Another violation without power cuts, if a few more flights find one: it is easier to
  /// understand than one with cuts that do not matter. Otherwise `found`.
  static Counterexample withoutUselessPowerCuts(Counterexample found, const Attempt& attempt,
                                                StrategyContext& context) {
    if (!context.powerCutsMatter() || attempt.holds_without_power_cuts) {
      return found;
    }
    constexpr unsigned kRounds = 6;
    const ProofContext powered = context.proof.proof_context.withoutPowerCuts();
    for (unsigned round = 1; round <= kRounds; ++round) {
      if (auto simpler = tryAtRandom(attempt.requirement, powered, context, round)) {
        return *std::move(simpler);
      }
    }
    return found;
  }
};

}  // namespace

const Strategy& strategy::randomFlightsWithoutPowerCuts() {
  static const RandomFlightsWithoutPowerCuts kStrategy;
  return kStrategy;
}

const Strategy& strategy::randomFlights() {
  static const RandomFlights kStrategy;
  return kStrategy;
}

}  // namespace glider::ir::prove
