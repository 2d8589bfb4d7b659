// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/context/budget.h"
#include "ir/prove/context/proof_context.h"
#include "ir/prove/context/state_bounds.h"
#include "ir/prove/encoding/any_moment.h"

#include <optional>
#include <vector>

namespace glider::ir::prove {

/// What is known of a mission before any search over traces, with power cuts or without: computed
/// once for all of its requirements.
class Insight {
 public:
  /// Both outlive this. `end`: of `proof_context`.
  Insight(const ProofContext& proof_context, const EndBound& end);
  Insight(const Insight&) = delete;
  Insight& operator=(const Insight&) = delete;

  /// The mission, with what the end bound says of its clocks.
  [[nodiscard]] const ProofContext& context() const { return context_; }

  /// For each state.
  const std::vector<StateBounds>& byState();

  /// Whether `requirement` is proved. `effort`: the limit of each question.
  [[nodiscard]] bool proves(const Requirement& requirement, unsigned effort, Budget& budget);
  /// `requirement` has been proved: it is known from now on.
  void know(const Requirement& requirement);

 private:
  double submersion();

  ProofContext context_;
  const EndBound& end_;
  std::vector<StateBounds> by_state_;
  bool knows_climbs_ = false;        ///< StateBounds::climbs of `by_state_` are set
  std::vector<StateBounds> bounds_;  ///< of those that may become current
  AnyMoment moment_;
  double ended_by_;  ///< mission time, s; infinite: not known
  double surfaces_every_;
  std::optional<double> submersion_;  ///< infinite: not bounded; none: not asked for yet
};

}  // namespace glider::ir::prove
