// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/names/scope.h"

namespace glider::frontend {

/// Reads the `declination` line into Scope::declination. To be called when constants are known.
void lowerDeclination(const ast::File& file, Scope& scope);

/// Lowers the mission's compass, if it reads or commands headings: its declination, and the
/// vehicle's sensor of the magnetic variation. To be called when everything else is lowered.
void lowerCompass(const ast::File& file, Scope& scope);

}  // namespace glider::frontend
