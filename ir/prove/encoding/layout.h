// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/encoding/tick.h"

#include <vector>

namespace glider::ir::prove {

/// The terms of a configuration in a row, for a predicate over those with the same control: which
/// they are follows from the control and from what is relevant.
class Layout {
 public:
  /// `memory` are the sorts of what the question keeps. All outlive this.
  Layout(const ProofContext& proof_context, const ConeOfInfluence& relevance,
         const std::vector<z3::sort>& memory)
      : proof_context_(proof_context),
        m_(proof_context.mission),
        relevance_(relevance),
        memory_(memory) {}

  /// A configuration of unknowns.
  Configuration make(const Control& control, Unknowns& unknowns) const;
  /// Its terms; those of `make` are unknowns, each another.
  [[nodiscard]] std::vector<z3::expr> row(const Configuration& configuration) const;

 private:
  /// Whether a variable is kept while the control is this.
  [[nodiscard]] bool keeps(const Control& control, uint32_t variable) const;
  /// Whether a temporal is watched now.
  [[nodiscard]] bool watches(const Control& control, uint32_t temporal) const;

  const ProofContext& proof_context_;
  const Mission& m_;
  const ConeOfInfluence& relevance_;
  const std::vector<z3::sort>& memory_;
};

}  // namespace glider::ir::prove
