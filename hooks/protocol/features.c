// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/features.h"

uint16_t hookMissingFeatures(const HookFeatures* one, const HookFeatures* other) {
  return (uint16_t)((one->needs & ~other->offers) | (other->needs & ~one->offers));
}
