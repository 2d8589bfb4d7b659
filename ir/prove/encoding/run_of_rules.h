// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/encoding/chc_encoder.h"

#include <optional>
#include <vector>

namespace glider::ir::prove {

/// Values for all that rules `trace` (numbers, the start first, what is bad last) leave open: the
/// run that takes them one after another.
std::optional<Run> runOfRules(z3::context& context, const ProofContext& proof_context,
                              const std::vector<Rule>& rules, const std::vector<size_t>& trace,
                              unsigned effort);

}  // namespace glider::ir::prove
