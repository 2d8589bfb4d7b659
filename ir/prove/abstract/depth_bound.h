// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/context/proof_context.h"

namespace glider::ir::prove {

/// Whether a condition is true at every tick because of the commands alone: no command of the
/// mission leads deeper than the condition allows, for all values that its arguments may have.
/// `deepest`: the greatest of deepestByState. True is a proof in the environment model of
/// ir/prove/encoding/world.h; false proves nothing.
bool heldByCommands(ExprId condition, const ProofContext& proof_context, double deepest);

}  // namespace glider::ir::prove
