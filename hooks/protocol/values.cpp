// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/values.h"

namespace glider::hooks {

uint16_t nextSequence(uint16_t sequence) {
  return static_cast<uint16_t>(sequence % UINT16_MAX + 1);
}

bool isNewerSequence(uint16_t sequence, uint16_t other) {
  // Serial number arithmetic (RFC 1982) modulo 65535: no number has an opposite.
  const uint32_t ahead = (uint32_t{sequence} + UINT16_MAX - other) % UINT16_MAX;
  return sequence != 0 && (other == 0 || (ahead != 0 && ahead <= UINT16_MAX / 2));
}

}  // namespace glider::hooks
