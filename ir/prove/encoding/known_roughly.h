// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/encoding/tick.h"

#include <string>

namespace glider::ir::prove {

/// The operations in the cone of influence of a question that the solver only approximates, in
/// words: "products, windows"; empty if there are none.
std::string knownRoughly(const ProofContext& proof_context, const ConeOfInfluence& relevance);

}  // namespace glider::ir::prove
