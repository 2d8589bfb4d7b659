// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

/// The baseline packet of JANUS (ANEP-87, STANAG 4748), the acoustic signal that modems of all
/// makers can send (README.md). No heap.
namespace glider::hooks::janus {

inline constexpr uint32_t kPacketBytes = 8;
inline constexpr uint32_t kBlockBits = 34;
inline constexpr uint64_t kMostBlock = (uint64_t{1} << kBlockBits) - 1;
inline constexpr uint32_t kMostApplication = 63;
inline constexpr uint32_t kVersion = 3;
/// The class of the reference implementation, which anybody may use.
inline constexpr uint8_t kReferenceClass = 16;

struct Packet {
  bool mobile = true;      ///< the sender moves
  bool scheduled = false;  ///< the block begins with a reservation or a time of repetition
  bool hears = true;       ///< the sender receives as well
  bool forwards = false;   ///< it passes on packets of others
  uint8_t class_id = kReferenceClass;
  uint32_t application = 0;  ///< within the class; at most kMostApplication
  uint64_t block = 0;        ///< at most kMostBlock
};

/// Writes `packet` as sent: kPacketBytes, the first bit first. False, and nothing is written, if a
/// number of it is too great.
[[nodiscard]] bool encode(const Packet& packet, uint8_t* bytes);

/// Reads kPacketBytes. False, and `packet` has no meaning, if they are of another version, or their
/// check does not agree.
[[nodiscard]] bool decode(const uint8_t* bytes, Packet& packet);

}  // namespace glider::hooks::janus
