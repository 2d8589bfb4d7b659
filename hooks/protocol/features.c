// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/features.h"

uint16_t hookMissingFeatures(const HookFeatures* one, const HookFeatures* other) {
  return (uint16_t)((one->needs & ~other->offers) | (other->needs & ~one->offers));
}

uint8_t hookLowestFeature(uint16_t features) {
  uint8_t bit = 0;
  while (bit < 15 && ((uint32_t)features >> bit & 1U) == 0) {
    ++bit;
  }
  return bit;
}

const char* hookFeatureName(uint8_t bit) {
  switch (bit) {
#define FEATURE(name, number, text) \
  case number:                      \
    return text;
#include "hooks/protocol/features.def"
    default:
      return NULL;
  }
}
