// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/names/scope.h"

#include <string_view>

namespace glider::frontend {

/// The first line `share` for `name`, or of all if that is empty; null: none.
const ast::Share* firstShare(const ast::File& file, std::string_view name);

/// Reports what the modem of the vehicle cannot send, and a vehicle without a modem or a clock.
/// Subscribes the clock by which vehicles take turns.
void checkShareFit(const ast::File& file, Scope& scope);

}  // namespace glider::frontend
