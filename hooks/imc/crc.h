// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

namespace glider::hooks::imc {

/// CRC-16/ARC as listed in Greg Cook's catalogue of CRC algorithms: polynomial 0x8005, start 0,
/// reflected; "123456789" gives 0xBB3D.
uint16_t crc16Arc(const uint8_t* bytes, uint32_t count);

}  // namespace glider::hooks::imc
