// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/encoding/tick.h"

#include <vector>

namespace glider::ir::prove {

/// The cone of influence of the transitions of a trace and of the expressions `asked`; with
/// `vehicle` also of the vehicle's depth.
ConeOfInfluence relevanceFor(const Mission& mission, const std::vector<ExprId>& asked,
                             bool vehicle);

}  // namespace glider::ir::prove
