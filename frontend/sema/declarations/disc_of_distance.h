// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/sema/names/scope.h"
#include "ir/core/mission.h"

#include <optional>

namespace glider::frontend {

/// The disc that the vehicle must stay in, or out of, if the condition `id` must be true (`wanted`)
/// or false: it compares the distance between the vehicle and a place with a radius, both known at
/// compile time. Empty for any other condition.
std::optional<ir::Geofence> discOf(ir::ExprId id, bool wanted, Scope& scope);

}  // namespace glider::frontend
