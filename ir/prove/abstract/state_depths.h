// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/context/proof_context.h"

#include <vector>

namespace glider::ir::prove {

/// For each state, the upper bound of the depth (m) while it is current, from the commands alone:
/// its own and those of every state that may have been current before. Infinite where a behaviour
/// in C may command anything, or a command has no known range. In the environment model of
/// ir/prove/encoding/world.h.
std::vector<double> deepestByState(const ProofContext& proof_context);

}  // namespace glider::ir::prove
