// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/evidence/evidence.h"
#include "ir/prove/passes.h"
#include "ir/prove/requirements/insight.h"

#include <optional>
#include <string>
#include <vector>

namespace glider::ir::prove {

/// How many random flights of a length were tried.
struct Flown {
  double span_s = 0;
  uint64_t count = 0;
};

/// What the strategies share: a mission, with its assumptions or without, the budget, and what is
/// known of it so far.
class StrategyContext {
 public:
  /// Both outlive this. `bare`: of the mission without its assumptions; null if it has none, or
  /// nothing may rest on them.
  explicit StrategyContext(Proof& proof, StrategyContext* bare = nullptr);

  Proof& proof;
  StrategyContext* bare;
  const Mission& mission;
  double deepest;                     ///< of all states, m
  unsigned search_effort;             ///< the limit of a search
  bool learnt = false;                ///< a requirement was proved after the phase AtOnce
  std::vector<Flown> flown = {};      ///< for the requirement that is searched for
  std::optional<Run> submerged = {};  ///< without power cuts; violates a `surfaces every`

  /// A question that was not answered may take so much more of `search_effort`, once.
  static constexpr unsigned kLonger = 6;

  /// With power cuts.
  [[nodiscard]] Insight& insight();
  [[nodiscard]] Insight& insightWithoutPowerCuts();
  [[nodiscard]] EvidenceBuilder& evidences();
  /// What proofs rest on is collected, so that it can be checked again.
  [[nodiscard]] bool wantsEvidence() const { return proof.options.evidence; }
  /// Whether a power cut may make the time between two ticks longer than it is anyway.
  [[nodiscard]] bool powerCutsMatter() const;
  /// Why nothing more is tried, once Proof::searches is used up.
  [[nodiscard]] std::string limitReached() const;

 private:
  std::optional<Insight> insight_;  ///< none: not asked for yet
  std::optional<Insight> powered_;
  std::optional<EvidenceBuilder> evidences_;
};

/// The verdict that `run` violates `requirement`, reported (GL3110).
RequirementVerdict refutedBy(Counterexample run, const Requirement& requirement,
                             const StrategyContext& context);

}  // namespace glider::ir::prove
