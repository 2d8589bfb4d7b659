// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "ir/prove/prove.h"

#include <filesystem>
#include <string>

namespace glider::compiler {

/// What earlier checks have proved, or could not, so that a long search is made once: a file for
/// each requirement, in ${XDG_CACHE_HOME:-~/.cache}/glidercc/proofs. A file speaks of this very
/// program, mission, vehicle and effort only. What is refuted is searched for again, for its run
/// has to be spelled out. A file that is damaged, or cannot be read or written, is as good as none.
class ProofCache {
 public:
  /// Of a mission, with the efforts of `how`.
  ProofCache(const Checked& checked, const ir::prove::Options& how);

  /// What is kept of the requirement with that number.
  [[nodiscard]] std::optional<ir::prove::CachedVerdict> find(uint32_t requirement) const;
  /// Keeps what took a search, and lets the oldest go when there are many.
  void keep(const std::vector<ir::prove::RequirementVerdict>& verdicts) const;

 private:
  [[nodiscard]] std::filesystem::path fileOf(uint32_t requirement) const;

  std::filesystem::path folder_;  ///< empty: nothing is kept
  std::string all_;               ///< what every answer depends on
};

}  // namespace glider::compiler
