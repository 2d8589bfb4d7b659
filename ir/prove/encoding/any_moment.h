// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/context/state_bounds.h"
#include "ir/prove/encoding/question.h"

#include <vector>

namespace glider::ir::prove {

/// Proofs that a condition is false at no moment of any trace, each from one question about a
/// single moment: for any readings, any values of variables in their ranges, the clocks in order
/// and the true depth within StateBounds. It needs no search over traces, so it costs the same for
/// ten states and for thousands.
class AnyMoment {
 public:
  /// `proof_context` and `bounds` outlive this.
  AnyMoment(const ProofContext& proof_context, const std::vector<StateBounds>& bounds)
      : proof_context_(proof_context), bounds_(bounds) {}

  /// A condition that has been proved never to be false, from now on known for later ones.
  void know(ExprId condition) { known_.push_back(condition); }
  /// Whether `condition` is proved. Asks first about all states together, then about each apart, if
  /// they are not too many. `effort`: the limit of each question.
  [[nodiscard]] bool neverFalse(ExprId condition, unsigned effort, Budget& budget);
  /// Whether it is false at some moment within all bounds together: a proof too, so neither holds
  /// where the question has no answer.
  [[nodiscard]] bool mayBeFalse(ExprId condition, unsigned effort, Budget& budget) {
    return falseWithin(condition, hullOf(bounds_), effort, budget) == Answer::Yes;
  }

 private:
  [[nodiscard]] Answer falseWithin(ExprId condition, const StateBounds& bounds, unsigned effort,
                                   Budget& budget);

  const ProofContext& proof_context_;
  const std::vector<StateBounds>& bounds_;
  std::vector<ExprId> known_;
  z3::context context_;  ///< of all questions
};

}  // namespace glider::ir::prove
