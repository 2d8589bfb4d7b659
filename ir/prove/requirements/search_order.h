// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <cstdint>
#include <vector>

namespace glider::ir::prove {

/// The order in which to search for a verdict on `waiting`, numbers of requirements: as they are,
/// but of several `surfaces every` the middle one comes first. What is proved about one holds for
/// every longer time, and what violates it violates every shorter: so few of them take a search.
std::vector<uint32_t> searchOrder(std::vector<uint32_t> waiting,
                                  const std::vector<Requirement>& requirements);

}  // namespace glider::ir::prove
