// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/encoding/symbolic_state.h"

#include <span>

namespace glider::ir::prove {

/// Whether `guard` is true of the values that `model` gives `moment`, evaluated as a mission does.
/// Z3 takes the results of functions and products for free: without this, what the report says of a
/// model may be false.
bool isConfirmed(const z3::model& model, SymbolicState& moment, ExprId guard);

/// Whether the results that `model` gives to what Z3 takes for free are those of the readings of
/// one of these moments. Results that depend on more than readings are not checked.
bool fitReadings(const z3::model& model, const Unknowns& unknowns,
                 std::span<SymbolicState* const> moments);

}  // namespace glider::ir::prove
