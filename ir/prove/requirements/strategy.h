// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/prove.h"
#include "ir/prove/requirements/strategy_context.h"

#include <optional>
#include <span>
#include <string>

/// The strategies that decide requirements: how each proves or refutes, which evidence its proofs
/// have, and on which assumptions they may rest.
namespace glider::ir::prove {

/// The attempt to decide one requirement: what the strategies in the phase Search tell those after
/// them.
struct Attempt {
  uint32_t number;  ///< of the requirement
  const Requirement& requirement;
  std::string reason = {};  ///< why it is not decided, if nothing after decides it
  /// A trace with power cuts that violates it: reported only if there is none without.
  std::optional<Counterexample> with_power_cuts = {};
  bool holds_without_power_cuts = false;  ///< proved
};

/// A proof under fewer assumptions than the first.
struct RepeatedProof {
  bool proved = false;
  std::optional<Evidence> evidence = {};
};

/// A way to decide requirements. It has no state: what it keeps is in the StrategyContext.
class Strategy {
 public:
  Strategy() = default;
  virtual ~Strategy() = default;
  Strategy(const Strategy&) = delete;
  Strategy& operator=(const Strategy&) = delete;

  /// Whether it can decide requirements like this one; it is asked nothing about others.
  [[nodiscard]] virtual bool serves(const Requirement& requirement) const = 0;

  /// Whether `requirement` is proved; nothing is reported. Only in the phases AtOnce and
  /// AtOnceAndAgain.
  virtual bool proves(const Requirement& requirement, StrategyContext& context) const;

  /// The verdict, reported if it is Refuted; none: the next strategy is tried. By default what
  /// proves() says.
  virtual std::optional<RequirementVerdict> judge(Attempt& attempt, StrategyContext& context) const;

  /// Whether what was proved under more assumptions is proved in `context` too; `was`: the first
  /// verdict, by any strategy. Nothing is reported. By default what proves() says.
  virtual RepeatedProof provesAgain(const RequirementVerdict& was, StrategyContext& context) const;

  /// What a proof of `requirement` by this strategy rests on, if the verdict does not have it yet;
  /// `learnt`: it may rest on proofs by Spacer of other requirements.
  [[nodiscard]] virtual std::optional<Evidence> evidence(const Requirement& requirement,
                                                         bool learnt,
                                                         StrategyContext& context) const;

  /// Whether a proof of `requirement` by this strategy may rest on `assumption`.
  [[nodiscard]] virtual bool mayRestOn(const Assumption& assumption,
                                       const Requirement& requirement) const;

 protected:
  /// The proof of `requirement` again, with its evidence if evidence is collected.
  RepeatedProof provedAgain(const Requirement& requirement, StrategyContext& context) const;
  /// The same by what a search has found again; none: nothing.
  static RepeatedProof againBy(std::optional<RequirementVerdict> verdict);
};

enum class Phase : uint8_t { AtOnce, AtOnceAndAgain, Search };

/// A row of strategies.def.
struct StrategyRow {
  const Strategy& strategy;
  Phase phase;
};

/// In the order in which they are tried.
std::span<const StrategyRow> strategies();

namespace strategy {
#define STRATEGY(name, phase, purpose) const Strategy& name();
#include "ir/prove/requirements/strategies.def"
#undef STRATEGY
}  // namespace strategy

}  // namespace glider::ir::prove
