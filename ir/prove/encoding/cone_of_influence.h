// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/encoding/tick.h"

#include <vector>

namespace glider::ir::prove {

/// What matters to where a run goes and to the expressions `asked`; with `vehicle` also to its
/// depth.
ConeOfInfluence relevanceFor(const Mission& mission, const std::vector<ExprId>& asked,
                             bool vehicle);

}  // namespace glider::ir::prove
