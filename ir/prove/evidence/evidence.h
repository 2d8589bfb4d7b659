// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/evidence/known.h"
#include "ir/prove/prove.h"

#include <optional>
#include <utility>
#include <vector>

namespace glider::ir::prove {

/// Collects what proofs rest on.
class EvidenceBuilder {
 public:
  /// `proof_context` outlives this. `end`: its bound.
  EvidenceBuilder(const ProofContext& proof_context, const EndBound& end)
      : proof_context_(proof_context), known_(proof_context, end) {}

  /// Of a proof by Spacer: `found` holds beside what is known without a search. From now on other
  /// proofs may rest on it.
  Evidence searched(const Requirement& requirement, std::vector<certify::Invariant> found);
  /// Of a proof without a search. `run`: it is a trace; `learnt`: it may rest on those by Spacer.
  /// None if the mission has more configurations than a certificate may list.
  [[nodiscard]] std::optional<Evidence> seen(const Requirement& requirement, bool run,
                                             bool learnt) const;

 private:
  using Invariants = std::vector<certify::Invariant>;

  [[nodiscard]] std::optional<Invariants> everywhere(const Requirement& requirement) const;
  [[nodiscard]] std::optional<Invariants> neverAfter(const Requirement& requirement) const;
  void addLearnt(const Requirement& requirement, Invariants& invariants) const;

  const ProofContext& proof_context_;
  Known known_;
  std::vector<std::pair<RequirementKind, Invariants>> learnt_;
};

}  // namespace glider::ir::prove
