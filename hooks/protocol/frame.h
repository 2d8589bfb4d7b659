// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

/// Frames: COBS-encoded {type, sequence, payload, CRC-16}, ended by a zero byte. See README.md.
namespace glider::hooks {

enum class MessageType : uint8_t {
#define MESSAGE(name, number, expects_answer) name = number,
#include "hooks/protocol/messages.def"
#undef MESSAGE
};

inline constexpr uint32_t kMostFrameBytes = 254;                    ///< type to CRC, before COBS
inline constexpr uint32_t kMostPayload = kMostFrameBytes - 4;       ///< without type, sequence, CRC
inline constexpr uint32_t kMostEncodedBytes = kMostFrameBytes + 2;  ///< COBS code byte, final zero

struct Frame {
  MessageType type = MessageType::Beacon;
  uint8_t sequence = 0;
  uint8_t size = 0;  ///< of the payload, at most kMostPayload
  uint8_t payload[kMostPayload] = {};
};

/// CRC-16/CCITT-FALSE (polynomial 0x1021, start 0xFFFF, not reflected; "123456789" gives 0x29B1),
/// as listed in Greg Cook's catalogue of CRC algorithms.
uint16_t crc16(const uint8_t* bytes, uint32_t count);

/// Writes `frame` as it goes on the line, final zero included, to `out` (at least
/// kMostEncodedBytes). Returns the number of bytes.
uint32_t encodeFrame(const Frame& frame, uint8_t* out);

/// Finds whole, checked frames in a stream of bytes. Any zero byte resynchronises it.
class FrameDecoder {
 public:
  /// Takes one byte. True when it completed a good frame, which stands in `frame` until the next
  /// call.
  bool push(uint8_t byte);
  [[nodiscard]] const Frame& frame() const { return frame_; }
  /// Frames thrown away since the start: too long or short, not COBS, wrong CRC, or of no known
  /// type.
  [[nodiscard]] uint32_t badFrames() const { return bad_frames_; }

 private:
  bool finish();
  /// Undoes COBS in place; returns the number of bytes, 0 if it is none.
  uint32_t unstuff();

  Frame frame_;
  uint8_t bytes_[kMostEncodedBytes] = {};
  uint32_t count_ = 0;  ///< kMostEncodedBytes: too long, skipping to the next zero
  uint32_t bad_frames_ = 0;
};

}  // namespace glider::hooks
