// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

/// Frames: COBS-encoded {type, sequence, payload, CRC}, ended by a zero byte. See README.md.
namespace glider::hooks {

enum class MessageType : uint8_t {
#define MESSAGE(name, number, expects_answer) name = number,
#include "hooks/protocol/messages.def"
#undef MESSAGE
};

inline constexpr uint32_t kMostPayload = 560;                  ///< without type, sequence, CRC
inline constexpr uint32_t kMostFrameBytes = kMostPayload + 6;  ///< type to CRC, before COBS
/// With one COBS code byte per 254 bytes or part of them, and the final zero.
inline constexpr uint32_t kMostEncodedBytes = kMostFrameBytes + kMostFrameBytes / 254 + 2;

struct Frame {
  MessageType type = MessageType::Beacon;
  uint8_t sequence = 0;
  uint16_t size = 0;  ///< of the payload, at most kMostPayload
  uint8_t payload[kMostPayload] = {};
};

/// The most bytes that a frame with a payload of this size takes on the line.
uint32_t encodedBound(uint32_t payload);
/// Writes `frame` as it goes on the line, final zero included, to `out` (at least
/// encodedBound of its size). Returns the number of bytes.
uint32_t encodeFrame(const Frame& frame, uint8_t* out);

/// Finds whole, checked frames in a stream of bytes. Any zero byte resynchronises it.
class FrameDecoder {
 public:
  /// Takes one byte. True when it completed a good frame, which is in `frame` until the next call.
  /// A frame identical to the previous good one, sequence included, is a repetition and is ignored.
  bool push(uint8_t byte);
  [[nodiscard]] const Frame& frame() const { return frame_; }
  /// Frames discarded since the start: too long or short, not COBS, wrong CRC, or of an unknown
  /// type.
  [[nodiscard]] uint32_t badFrames() const { return bad_frames_; }
  /// Frames ignored since the start because they were repeated.
  [[nodiscard]] uint32_t doubles() const { return doubles_; }

 private:
  void unstuff(uint8_t byte);
  void append(uint8_t byte);
  /// Whether the bytes are a good frame; its CRC into `check`.
  [[nodiscard]] bool isGood(uint32_t* check) const;
  bool finish();
  void begin();

  Frame frame_;
  uint8_t bytes_[kMostFrameBytes] = {};
  uint32_t count_ = 0;
  uint8_t group_left_ = 0;     ///< bytes to come before the next COBS code byte
  bool zero_follows_ = false;  ///< there is a zero between this COBS group and the next
  bool begun_ = false;         ///< a byte came since the last zero
  bool too_long_ = false;
  bool any_ = false;  ///< a good frame came: frame_ with the CRC last_check_
  uint32_t last_check_ = 0;
  uint32_t bad_frames_ = 0;
  uint32_t doubles_ = 0;
};

}  // namespace glider::hooks
