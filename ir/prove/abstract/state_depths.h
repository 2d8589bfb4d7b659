// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/ground/ground.h"

#include <vector>

namespace glider::ir::prove {

/// By state: where no run is deeper (m) while it is current, by the orders alone: its own and those
/// of every state that may have been current before. Infinite where a behaviour in C may order
/// anything, or an order has no known range. In the world of ir/prove/encoding/world.h.
std::vector<double> deepestByState(const Ground& ground);

}  // namespace glider::ir::prove
