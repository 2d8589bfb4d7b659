// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

namespace glider::ir::prove {

/// Whether two expressions are the same, so that at one moment they have one value: the frontend
/// lowers an index of a path once for each coordinate.
bool isSameExpression(const Mission& mission, ExprId a, ExprId b);

}  // namespace glider::ir::prove
