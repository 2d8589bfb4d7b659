// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <functional>
#include <optional>
#include <vector>

namespace glider::ir::prove {

/// What a guard says of the depth: it is true only at `limit` or deeper, or only at `limit` or
/// shallower.
struct DepthCondition {
  bool deeper = false;
  ExprId limit;
};

/// All such conditions that `guard` implies where the depth is known. `never`: whether a part of it
/// is never true then.
std::vector<DepthCondition> depthConditions(const Mission& mission, ExprId guard, SensorId depth,
                                            const std::function<bool(ExprId)>& never);

/// `a` less `b`, for any values of the variables that they read, if they are sums of the same terms
/// and constants; otherwise none.
std::optional<double> constantDifference(const Mission& mission, ExprId a, ExprId b);

}  // namespace glider::ir::prove
