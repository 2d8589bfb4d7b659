// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/budget/image.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <vector>

namespace glider::codegen {

/// Reads the word that is loaded at an address.
using WordAt = std::function<std::optional<uint32_t>(uint64_t)>;
/// Where the function of an instruction begins.
using StartOf = std::function<uint64_t(uint64_t)>;

/// All values in `code` (by address) that may be addresses: operands, distances from where they are
/// used, distances from `offsets` (x86's _GLOBAL_OFFSET_TABLE_; 0: none), sums of a page and a
/// number.
std::set<uint64_t> addressesIn(const std::vector<Instruction>& code, uint64_t offsets,
                               const WordAt& word_at, const StartOf& start_of);

/// The places where ARM's code keeps words that are only distances: each is loaded into a register
/// whose next use adds it to the place.
std::set<uint64_t> distancesIn(const std::vector<Instruction>& code);

}  // namespace glider::codegen
