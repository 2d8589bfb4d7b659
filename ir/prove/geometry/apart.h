// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <vector>

namespace glider::ir::prove {

/// A lower bound, m, of the distance between a place that keeps all of `one` and a place that keeps
/// all of `other`; 0 if they may be the same place. Only areas to stay in count.
double leastApart(const std::vector<Geofence>& one, const std::vector<Geofence>& other);

}  // namespace glider::ir::prove
