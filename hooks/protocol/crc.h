// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

/// The check values of the hook protocol, as listed in Greg Cook's catalogue of CRC algorithms. For
/// bytes in several pieces, pass the CRC of the earlier pieces as `before`.
namespace glider::hooks {

/// CRC-16/CCITT-FALSE: polynomial 0x1021, start 0xFFFF, not reflected; "123456789" gives 0x29B1.
uint16_t crc16(const uint8_t* bytes, uint32_t count, uint16_t before = 0xFFFF);

/// CRC-32C (Castagnoli): polynomial 0x1EDC6F41, start and final xor all ones, reflected;
/// "123456789" gives 0xE3069283. It finds any five wrong bits in up to 655 bytes (Koopman 2002,
/// doi 10.1109/DSN.2002.1028931).
uint32_t crc32c(const uint8_t* bytes, uint32_t count, uint32_t before = 0);

}  // namespace glider::hooks
