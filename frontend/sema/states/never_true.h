// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <optional>

namespace glider::frontend {

/// The sensor that makes a condition false at any value: its comparisons with constants, joined by
/// `&&`, exclude each other, as in `depth < 10 m && depth > 30 m`. Empty: none does.
std::optional<ir::SensorId> neverTrueFor(const ir::Mission& mission, ir::ExprId condition);

}  // namespace glider::frontend
