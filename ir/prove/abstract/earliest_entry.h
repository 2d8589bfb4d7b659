// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/context/proof_context.h"

#include <vector>

namespace glider::ir::prove {

/// Of every state: no run enters it before this mission time, s; infinite: none enters it at all.
/// By the clocks alone, whatever sensors and variables are worth.
std::vector<double> earliestEntries(const ProofContext& proof_context);

}  // namespace glider::ir::prove
