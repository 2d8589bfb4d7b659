// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/abstract/abstract_evaluator.h"
#include "ir/prove/context/proof_context.h"

#include <optional>

namespace glider::ir::prove {

/// The shallowest depth to which the commands of a state lead, m.
struct Shallowest {
  double target_m = 0;
  double reading_m = 0;  ///< a vehicle that flies there does not read less
};

/// The commands of states, given while the depth is known: what a profile does without a reading of
/// the depth does not count.
class ShallowestCommands {
 public:
  /// `proof_context` outlives this.
  explicit ShallowestCommands(const ProofContext& proof_context);
  /// None if a state may command the surface or any depth, or commands none of its own.
  [[nodiscard]] std::optional<Shallowest> of(StateId state) const;

 private:
  void addCases(const std::vector<Case>& cases, std::vector<const Statement*>& commands) const;
  void addBlock(BlockId block, std::vector<const Statement*>& commands) const;

  ProofContext seen_;  ///< with a depth that is always known
  const Mission& m_;
  Valuation values_;
  std::vector<Interval> held_;  ///< of every expression
  AbstractEvaluator possible_;
};

}  // namespace glider::ir::prove
