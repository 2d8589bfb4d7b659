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
  /// Of a proof by bounds on times, depths and what holds at any moment. `learnt`: it may rest on
  /// proofs by Spacer. Of this and the next two there is none if the mission has more
  /// configurations than a certificate may list.
  [[nodiscard]] std::optional<Evidence> bound(const Requirement& requirement, bool learnt) const;
  /// Of a proof of StackAtMost from the calls alone.
  [[nodiscard]] std::optional<Evidence> callDepth(const Requirement& requirement) const;
  /// Of a proof of NeverAfter from the transitions alone.
  [[nodiscard]] std::optional<Evidence> neverAfter(const Requirement& requirement) const;

 private:
  using Invariants = std::vector<certify::Invariant>;

  [[nodiscard]] std::optional<Invariants> everywhere(const Requirement& requirement) const;
  void addLearnt(const Requirement& requirement, Invariants& invariants) const;

  const ProofContext& proof_context_;
  Known known_;
  std::vector<std::pair<RequirementKind, Invariants>> learnt_;
};

}  // namespace glider::ir::prove
