// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

/// Parts of the protocol that one side may lack. Each side states in Beacon or Hello what it offers
/// and what it needs; a link is possible if each offers what the other needs.
namespace glider::hooks {

/// Sets of features are bits of a u16.
enum Feature : uint16_t {
#define FEATURE(name, bit, text) kFeature##name = 1U << (bit),
#include "hooks/protocol/features.def"
};

inline constexpr uint16_t kAllFeatures = 0
#define FEATURE(name, bit, text) | kFeature##name
#include "hooks/protocol/features.def"
    ;

struct Features {
  uint16_t offers = 0;
  uint16_t needs = 0;  ///< of the other side
  bool operator==(const Features&) const = default;
};

/// The features that one of the two needs and the other does not offer.
constexpr uint16_t missingFeatures(const Features& one, const Features& other) {
  return static_cast<uint16_t>((one.needs & ~other.offers) | (other.needs & ~one.offers));
}

/// The number of the lowest feature in `features`, which must not be empty.
constexpr uint8_t lowestFeature(uint16_t features) {
  uint8_t bit = 0;
  while (bit < 15 && (static_cast<unsigned>(features) >> bit & 1U) == 0) {
    ++bit;
  }
  return bit;
}

/// "virtual-time"; null for a feature of later versions.
constexpr const char* featureName(uint8_t bit) {
  switch (bit) {
#define FEATURE(name, number, text) \
  case number:                      \
    return text;
#include "hooks/protocol/features.def"
    default:
      return nullptr;
  }
}

}  // namespace glider::hooks
