// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/sema/names/scope.h"

namespace glider::frontend {

/// Reads the line `vehicles`: the names of a fleet. To be called before anything reads `ada.top`.
void lowerVehicles(const ast::File& file, Scope& scope);

/// Adds to the shares what the mission reads of named vehicles. To be called once everything is
/// lowered.
void finishVehicles(Scope& scope);

}  // namespace glider::frontend
