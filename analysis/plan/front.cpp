// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/plan/front.h"

#include <algorithm>
#include <functional>

namespace glider::analysis {

std::vector<ScoredPlan> frontOf(std::span<const ScoredPlan> plans) {
  // In lexicographic order, whoever beats a plan comes before it.
  std::vector<ScoredPlan> front;
  for (const ScoredPlan& plan : plans) {
    const bool beaten = std::ranges::any_of(front, [&](const ScoredPlan& other) {
      return std::ranges::equal(other.scores, plan.scores, std::ranges::less_equal());
    });
    if (!beaten) {
      front.push_back(plan);
    }
  }
  return front;
}

}  // namespace glider::analysis
