// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <cstdint>
#include <vector>

namespace glider::ir::text {

/// Which expressions are written inside their user and which get a name of their own, so that a
/// reader who numbers expressions where they end gives each the number that it has in the mission.
/// `Mission::exprs` is divided into trees of consecutive numbers; `first` is where the tree of each
/// expression begins.
struct Layout {
  std::vector<uint32_t> uses;   ///< by operands and by everything outside expressions
  std::vector<uint32_t> first;  ///< the lowest number in the tree that ends here
  std::vector<bool> inside;     ///< written inside its user
};

Layout layOut(const Mission& mission);

/// For each block, the lowest number in the tree of blocks that ends there if all of them are
/// written inside their user; UINT32_MAX where their numbers do not allow that.
std::vector<uint32_t> layOutBlocks(const Mission& mission);

}  // namespace glider::ir::text
