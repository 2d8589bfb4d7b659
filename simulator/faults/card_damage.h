// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/faults/faults.h"

#include <cstdint>
#include <vector>

namespace glider::simulator {

/// Damages the bytes of a file on a storage card as `fault` says. The same seed gives the same
/// damage. An empty file stays empty.
void damageCard(const CardFault& fault, uint64_t seed, std::vector<uint8_t>& bytes);

}  // namespace glider::simulator
