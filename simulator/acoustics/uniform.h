// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <Random123/philox.h>

#include <array>
#include <cstdint>

namespace glider::simulator {

/// A number above 0 and below 1 that depends only on the seed and on what it is for.
inline double uniform(uint64_t seed, const std::array<uint32_t, 4>& what) {
  const r123::Philox4x32::key_type key{
      {static_cast<uint32_t>(seed), static_cast<uint32_t>(seed >> 32U)}};
  const auto bits = r123::Philox4x32()({{what[0], what[1], what[2], what[3]}}, key);
  return (static_cast<double>(bits[0]) + 0.5) * 0x1p-32;
}

}  // namespace glider::simulator
