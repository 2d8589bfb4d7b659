// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "ir/prove/prove.h"

#include <filesystem>
#include <string>

namespace glider::compiler {

/// The proofs of earlier checks, so that a long search is made only once: a certificate for each
/// requirement in ${XDG_CACHE_HOME:-~/.cache}/glidercc/proofs. It counts only if it proves the
/// requirement again, so no one has to trust these files. What was undecided or
/// refuted is not kept: it cannot be checked without the search. A file that is damaged, or cannot
/// be read or written, is ignored.
class ProofCache {
 public:
  /// For a mission, which outlives this; `effort` is the resource limit of a question.
  ProofCache(const Checked& checked, unsigned effort);

  /// The stored proof of the requirement with that number, checked again.
  [[nodiscard]] std::optional<ir::prove::EarlierProof> find(uint32_t requirement) const;
  /// Stores the proofs that took a search, and removes the oldest files when there are many.
  void keep(const std::vector<ir::prove::RequirementVerdict>& verdicts) const;

 private:
  [[nodiscard]] std::filesystem::path fileOf(uint32_t requirement) const;

  const Checked& checked_;
  unsigned effort_;
  std::filesystem::path folder_;  ///< empty: nothing is stored
  std::string subject_;           ///< the digest of mission and vehicle
};

}  // namespace glider::compiler
