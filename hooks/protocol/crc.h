// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_PROTOCOL_CRC_H
#define GLIDER_HOOKS_PROTOCOL_CRC_H

#include "hooks/protocol/language.h"

/// The check values of the hook protocol, as listed in Greg Cook's catalogue of CRC algorithms. For
/// bytes in several pieces, pass the CRC of the earlier pieces as `before`.
GLIDER_HOOKS_BEGIN

enum { kHookCrc16Start = 0xFFFF, kHookCrc32cStart = 0 };

/// CRC-16/CCITT-FALSE: polynomial 0x1021, start 0xFFFF, not reflected; "123456789" gives 0x29B1.
uint16_t hookCrc16(const uint8_t* bytes, uint32_t count, uint16_t before);

/// CRC-32C (Castagnoli): polynomial 0x1EDC6F41, start and final xor all ones, reflected;
/// "123456789" gives 0xE3069283. It finds any five wrong bits in up to 655 bytes (Koopman 2002,
/// doi 10.1109/DSN.2002.1028931).
uint32_t hookCrc32c(const uint8_t* bytes, uint32_t count, uint32_t before);

GLIDER_HOOKS_END

#ifdef __cplusplus
namespace glider::hooks {
// With the start of each by itself.
inline uint16_t crc16(const uint8_t* bytes, uint32_t count, uint16_t before = 0xFFFF) {
  return hookCrc16(bytes, count, before);
}
inline uint32_t crc32c(const uint8_t* bytes, uint32_t count, uint32_t before = 0) {
  return hookCrc32c(bytes, count, before);
}
}  // namespace glider::hooks
#endif

#endif
