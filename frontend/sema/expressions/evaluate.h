// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <optional>

namespace glider::frontend {

/// The value of an expression that depends on no sensor and no clock, by the rules of ir/README.md:
/// NaN is unknown, conditions are 1 and 0. Empty if it does depend on one.
std::optional<double> evaluate(const ir::Mission& mission, ir::ExprId id);

}  // namespace glider::frontend
