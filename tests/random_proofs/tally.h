// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/prove.h"

#include <cstdint>
#include <map>
#include <string>

namespace glider::random_proofs {

/// What was tried, for those who want to know how much a run is worth.
struct Tally {
  struct Verdicts {
    size_t proved = 0, refuted = 0, undecided = 0;
    size_t met = 0;  ///< of the proved: no assumption was broken at once
    size_t assuming = 0;
  };
  struct Findings {
    size_t watched = 0;
    size_t met = 0;  ///< a flight was where it could have contradicted the finding
  };
  size_t missions = 0, flights = 0, ticks = 0;
  size_t restarts = 0;                           ///< after which a mission went on
  size_t begun_again = 0;                        ///< missions, after a restart
  std::map<std::string, Verdicts> requirements;  ///< by kind
  std::map<std::string, Findings> findings;      ///< by code

  void add(const std::string& kind, const ir::prove::RequirementVerdict& verdict);
  [[nodiscard]] std::string text() const;
};

}  // namespace glider::random_proofs
