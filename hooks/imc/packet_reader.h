// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/imc/packet.h"

#include <stdint.h>

namespace glider::hooks::imc {

/// Finds the packets in what arrives. What looks like the begin of one and is not hides nothing:
/// the search goes on at its second byte (README.md, rules I4 to I7). No heap; the work for each
/// byte is bounded.
class PacketReader {
 public:
  /// Takes bytes while there is room, and returns how many: at least one if next() has returned
  /// false since the last push.
  [[nodiscard]] uint32_t push(const uint8_t* bytes, uint32_t count);

  /// The next packet that is complete and has the right CRC; false: none. Its payload is valid
  /// until the next call of this, push() or reset().
  [[nodiscard]] bool next(Packet* packet);

  /// For a new connection: what has arrived of a packet on the old one is dropped.
  void reset();

  /// Bytes that belong to no packet. With those of the packets and those that are held they are all
  /// that was pushed.
  [[nodiscard]] uint32_t skippedBytes() const { return skipped_bytes_; }
  /// Headers whose packet was complete, with another CRC.
  [[nodiscard]] uint32_t badCrcs() const { return bad_crcs_; }
  /// Headers of a packet with a payload above kMostPayload.
  [[nodiscard]] uint32_t tooLong() const { return too_long_; }
  /// Bytes that may still become part of a packet, or were too few to look at.
  [[nodiscard]] uint32_t held() const { return end_ - begin_; }

 private:
  bool findSync(ByteOrder* order);
  bool take(ByteOrder order, uint32_t payload, Packet* packet);
  void skip(uint32_t count);

  /// Twice the longest packet, so that what is held moves at most once for each byte that arrives.
  uint8_t bytes_[2 * kMostPacket] = {};
  uint32_t begin_ = 0;
  uint32_t end_ = 0;
  uint32_t skipped_bytes_ = 0;
  uint32_t bad_crcs_ = 0;
  uint32_t too_long_ = 0;
};

}  // namespace glider::hooks::imc
