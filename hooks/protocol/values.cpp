// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/values.h"

#include "hooks/protocol/bytes.h"
#include "hooks/protocol/crc.h"
#include "hooks/protocol/numbers.h"

namespace glider::hooks {

uint16_t nextSequence(uint16_t sequence) {
  return static_cast<uint16_t>(sequence % UINT16_MAX + 1);
}

bool isNewerSequence(uint16_t sequence, uint16_t other) {
  // Serial number arithmetic (RFC 1982) modulo 65535: no number has an opposite.
  const uint32_t ahead = (uint32_t{sequence} + UINT16_MAX - other) % UINT16_MAX;
  return sequence != 0 && (other == 0 || (ahead != 0 && ahead <= UINT16_MAX / 2));
}

Instruction roundToArray(const Instruction& instruction) {
  Instruction rounded = instruction;
  rounded.depth_m = asFloat32(instruction.depth_m);
  rounded.pitch_rad = asFloat32(instruction.pitch_rad);
  rounded.heading_rad = asFloat32(instruction.heading_rad);
  return rounded;
}

uint16_t checkValue(const Instruction& instruction) {
  uint8_t bytes[37];
  ByteWriter out(bytes, sizeof bytes);
  out.u32(instruction.session);
  out.u16(instruction.sequence);
  out.u8(static_cast<uint8_t>(instruction.control));
  out.u8(static_cast<uint8_t>(instruction.vertical));
  out.u8(static_cast<uint8_t>(instruction.lateral));
  out.f32(static_cast<float>(instruction.depth_m));
  out.f32(static_cast<float>(instruction.pitch_rad));
  out.f32(static_cast<float>(instruction.heading_rad));
  out.f64(instruction.latitude_ddmm);
  out.f64(instruction.longitude_ddmm);
  return crc16(bytes, out.size());
}

}  // namespace glider::hooks
