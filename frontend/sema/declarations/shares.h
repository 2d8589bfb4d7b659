// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/names/scope.h"

namespace glider::frontend {

/// Lowers what a mission tells other vehicles, and enters what it may read of them: `peer.top`. The
/// mission's variables are lowered.
void lowerShares(const ast::File& file, Scope& scope);

/// Ends the shares, once everything that reads what is received is lowered: one that nothing reads
/// is not kept on board. Subscribes the clock by which vehicles take turns, and checks that the
/// vehicle's modem can send what is shared.
void finishShares(const ast::File& file, Scope& scope);

}  // namespace glider::frontend
