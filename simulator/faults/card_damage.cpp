// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/faults/card_damage.h"

#include "simulator/sensors/noise.h"

#include <algorithm>

namespace glider::simulator {
namespace {

constexpr size_t kBlock = 4096;

void flip(double count, Noise& noise, std::vector<uint8_t>& bytes) {
  for (double i = 0; i < count; i += 1) {
    const auto bit = static_cast<size_t>(noise.uniform() * static_cast<double>(bytes.size() * 8));
    bytes[bit / 8] = static_cast<uint8_t>(bytes[bit / 8] ^ (1U << (bit % 8)));
  }
}

void zeroBlocks(double share, Noise& noise, std::vector<uint8_t>& bytes) {
  for (size_t from = 0; from < bytes.size(); from += kBlock) {
    if (noise.uniform() < share) {
      std::fill_n(bytes.begin() + static_cast<ptrdiff_t>(from),
                  std::min(kBlock, bytes.size() - from), uint8_t{0});
    }
  }
}

}  // namespace

void damageCard(const CardFault& fault, uint64_t seed, std::vector<uint8_t>& bytes) {
  if (bytes.empty()) {
    return;
  }
  Noise noise(seed, static_cast<uint32_t>(NoiseStream::CardDamage));
  switch (fault.kind) {
    case CardFault::Kind::Flips:
      flip(fault.amount, noise, bytes);
      break;
    case CardFault::Kind::Cut:
      bytes.resize(static_cast<size_t>(fault.amount * static_cast<double>(bytes.size())));
      break;
    case CardFault::Kind::Zeroed:
      zeroBlocks(fault.amount, noise, bytes);
      break;
  }
}

}  // namespace glider::simulator
