// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <vector>

namespace glider::ir::opt {

/// Replaces each use of expression i by `by[i]`, which must not come after i, and drops what is no
/// longer used.
void replace(Mission& mission, const std::vector<ExprId>& by);

}  // namespace glider::ir::opt
