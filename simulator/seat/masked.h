// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/values.h"

#include <cstdint>

namespace glider::simulator {

/// Whether the slots in `masked`, hooks::kMaskedHeading…, include pitch or pump.
constexpr bool masksPitchOrPump(uint8_t masked) {
  return (masked & (hooks::kMaskedPitch | hooks::kMaskedPump)) != 0;
}

}  // namespace glider::simulator
