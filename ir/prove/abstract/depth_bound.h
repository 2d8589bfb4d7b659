// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/context/proof_context.h"

namespace glider::ir::prove {

/// Whether a condition is true at every tick for the commands alone: no command of the mission
/// leads deeper than it allows, whatever the ranges of what the commands are made from. True is a
/// proof in the world of ir/prove/encoding/world.h; false is none.
bool heldByOrders(ExprId condition, const ProofContext& proof_context);

}  // namespace glider::ir::prove
