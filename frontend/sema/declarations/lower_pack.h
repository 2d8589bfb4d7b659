// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/names/scope.h"

#include <span>

namespace glider::frontend {

/// Reads the line `pack` into Scope::energy and the mission. If `file` or what it imports
/// (`library`) asks for `energyused`, the mission gets a variable for the charge at its start. To
/// be called when constants are known.
void lowerPack(const ast::File& file, std::span<const ast::File* const> library, Scope& scope);

/// Gives that variable its value if the charge is not known at the start: by a last case of
/// `always`, which stays. To be called when the mission's `always` is lowered.
void keepFirstCharge(Scope& scope);

/// Warns of a reserve that no case of the mission keeps. To be called when all is lowered.
void warnOfReserve(Scope& scope);

}  // namespace glider::frontend
