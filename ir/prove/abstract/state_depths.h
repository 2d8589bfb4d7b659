// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/context/proof_context.h"

#include <vector>

namespace glider::ir::prove {

/// By state: where no run is deeper (m) while it is current, by the commands alone: its own and
/// those of every state that may have been current before. Infinite where a behaviour in C may
/// command anything, or a command has no known range. In the world of ir/prove/encoding/world.h.
std::vector<double> deepestByState(const ProofContext& proof_context);

}  // namespace glider::ir::prove
