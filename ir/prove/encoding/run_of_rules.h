// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/encoding/chc_encoder.h"

#include <optional>
#include <vector>

namespace glider::ir::prove {

/// Finds values for everything that the rules `trace` (numbers, the start first, the bad one last)
/// leave open, and returns the trace that uses these rules in order.
std::optional<Run> runOfRules(z3::context& context, const ProofContext& proof_context,
                              const std::vector<Rule>& rules, const std::vector<size_t>& trace,
                              unsigned effort);

}  // namespace glider::ir::prove
