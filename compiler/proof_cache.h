// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "ir/prove/prove.h"

#include <filesystem>
#include <string>

namespace glider::compiler {

/// The verdicts of earlier checks, proved or undecided, so that a long search is made only once: a
/// file for each requirement in ${XDG_CACHE_HOME:-~/.cache}/glidercc/proofs. A file applies only to
/// this exact program, mission, vehicle and resource limit. A refuted requirement is searched
/// again, because its counterexample has to be concretized. A file that is damaged, or cannot be
/// read or written, is ignored.
class ProofCache {
 public:
  /// For a mission, with the resource limits of `how`.
  ProofCache(const Checked& checked, const ir::prove::Options& how);

  /// The stored verdict of the requirement with that number.
  [[nodiscard]] std::optional<ir::prove::CachedVerdict> find(uint32_t requirement) const;
  /// Stores the verdicts that took a search, and removes the oldest files when there are many.
  void keep(const std::vector<ir::prove::RequirementVerdict>& verdicts) const;

 private:
  [[nodiscard]] std::filesystem::path fileOf(uint32_t requirement) const;

  std::filesystem::path folder_;  ///< empty: nothing is stored
  std::string all_;               ///< what every answer depends on
};

}  // namespace glider::compiler
