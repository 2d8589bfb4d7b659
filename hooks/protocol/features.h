// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_PROTOCOL_FEATURES_H
#define GLIDER_HOOKS_PROTOCOL_FEATURES_H

#include "hooks/protocol/language.h"

/// Parts of the protocol that one side may lack. Each side states in Beacon or Hello what it offers
/// and what it needs; a link is possible if each offers what the other needs.
GLIDER_HOOKS_BEGIN

/// Sets of features are bits of a u16.
enum {
#define FEATURE(name, bit, text) kHookFeature##name = 1U << (bit),
#include "hooks/protocol/features.def"
  kHookAllFeatures = 0
#define FEATURE(name, bit, text) | kHookFeature##name
#include "hooks/protocol/features.def"
};

typedef struct HookFeatures {
  uint16_t offers GLIDER_IS(0);
  uint16_t needs GLIDER_IS(0);  ///< of the other side
#ifdef __cplusplus
  bool operator==(const HookFeatures&) const = default;
#endif
} HookFeatures;

/// The features that one of the two needs and the other does not offer.
uint16_t hookMissingFeatures(const HookFeatures* one, const HookFeatures* other);

GLIDER_HOOKS_END

#ifdef __cplusplus
namespace glider::hooks {
using Features = HookFeatures;
// Of the type that a set of features has.
#define FEATURE(name, bit, text) inline constexpr uint16_t kFeature##name = kHookFeature##name;
#include "hooks/protocol/features.def"
inline constexpr uint16_t kAllFeatures = kHookAllFeatures;
inline uint16_t missingFeatures(const Features& one, const Features& other) {
  return hookMissingFeatures(&one, &other);
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
#endif

#endif
