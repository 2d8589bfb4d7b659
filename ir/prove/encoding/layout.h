// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/encoding/tick.h"

#include <vector>

namespace glider::ir::prove {

/// The terms of a configuration as a row, for a predicate over configurations with the same
/// control. The control and the cone of influence determine which terms they are.
class Layout {
 public:
  /// `memory`: the sorts of what the question keeps. All must outlive this.
  Layout(const ProofContext& proof_context, const ConeOfInfluence& relevance,
         const std::vector<z3::sort>& memory)
      : proof_context_(proof_context),
        m_(proof_context.mission),
        relevance_(relevance),
        memory_(memory) {}

  /// A configuration of unknowns.
  Configuration make(const Control& control, Unknowns& unknowns) const;
  /// Its terms; those of `make` are unknowns, all different.
  [[nodiscard]] std::vector<z3::expr> row(const Configuration& configuration) const;

 private:
  /// Whether a variable is kept with this control.
  [[nodiscard]] bool keeps(const Control& control, uint32_t variable) const;
  /// Whether a temporal is watched with this control.
  [[nodiscard]] bool watches(const Control& control, uint32_t temporal) const;

  const ProofContext& proof_context_;
  const Mission& m_;
  const ConeOfInfluence& relevance_;
  const std::vector<z3::sort>& memory_;
};

}  // namespace glider::ir::prove
