// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>

namespace glider::campaign {

/// The seed of a flight of a campaign. SplitMix64 (Steele et al. 2014, doi
/// 10.1145/2660193.2660195): neighbouring numbers get unrelated seeds.
inline uint64_t mixed(uint64_t seed, uint64_t number) {
  uint64_t z = seed + (number + 1) * 0x9E3779B97F4A7C15U;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return z ^ (z >> 31U);
}

}  // namespace glider::campaign
