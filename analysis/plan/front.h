// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "analysis/plan/scores.h"

#include <span>
#include <vector>

namespace glider::analysis {

/// Those of `plans` that no other equals or beats in every score (Pareto), in their order. `plans`
/// are sorted, the best first.
std::vector<ScoredPlan> frontOf(std::span<const ScoredPlan> plans);

}  // namespace glider::analysis
