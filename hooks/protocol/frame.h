// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_PROTOCOL_FRAME_H
#define GLIDER_HOOKS_PROTOCOL_FRAME_H

#include "hooks/protocol/language.h"

/// Frames: COBS-encoded {type, sequence, payload, CRC}, ended by a zero byte. See README.md.
#ifdef __cplusplus
enum class HookMessageType : uint8_t {
#define MESSAGE(name, number, expects_answer) name = number,
#include "hooks/protocol/messages.def"
};
#else
typedef uint8_t HookMessageType;
enum {
#define MESSAGE(name, number, expects_answer) kHookMessageType##name = number,
#include "hooks/protocol/messages.def"
};
#endif

GLIDER_HOOKS_BEGIN

enum {
  kHookMostPayload = 560,                      ///< without type, sequence, CRC
  kHookMostFrameBytes = kHookMostPayload + 6,  ///< type to CRC, before COBS
  /// With one COBS code byte per 254 bytes or part of them, and the final zero.
  kHookMostEncodedBytes = kHookMostFrameBytes + kHookMostFrameBytes / 254 + 2
};

typedef struct HookFrame {
  HookMessageType type GLIDER_IS(HookMessageType::Beacon);
  uint8_t sequence GLIDER_IS(0);
  uint16_t size GLIDER_IS(0);  ///< of the payload, at most kHookMostPayload
  uint8_t payload[kHookMostPayload] GLIDER_IS({});
} HookFrame;

/// The most bytes that a frame with a payload of this size takes on the line.
uint32_t hookEncodedBound(uint32_t payload);
/// Writes `frame` as it goes on the line, final zero included, to `out` (at least
/// hookEncodedBound of its size). Returns the number of bytes.
uint32_t hookEncodeFrame(const HookFrame* frame, uint8_t* out);

/// Finds whole, checked frames in a stream of bytes. Any zero byte resynchronises it. It begins
/// with all bytes zero.
typedef struct HookFrameDecoder {
  HookFrame frame;  ///< the newest good one
  uint8_t bytes[kHookMostFrameBytes] GLIDER_IS({});
  uint32_t count GLIDER_IS(0);
  uint8_t group_left GLIDER_IS(0);     ///< bytes to come before the next COBS code byte
  bool zero_follows GLIDER_IS(false);  ///< there is a zero between this COBS group and the next
  bool begun GLIDER_IS(false);         ///< a byte came since the last zero
  bool too_long GLIDER_IS(false);
  bool any GLIDER_IS(false);  ///< a good frame came: `frame` with the CRC last_check
  uint32_t last_check GLIDER_IS(0);
  /// Frames discarded since the start: too long or short, not COBS, wrong CRC, or of an unknown
  /// type.
  uint32_t bad_frames GLIDER_IS(0);
  /// Frames ignored since the start because they were repeated.
  uint32_t doubles GLIDER_IS(0);
} HookFrameDecoder;

/// Takes one byte. True when it completed a good frame, which is in `frame` until the next call.
/// A frame identical to the previous good one, sequence included, is a repetition and is ignored.
bool hookFrameDecoderPush(HookFrameDecoder* decoder, uint8_t byte);

GLIDER_HOOKS_END

#ifdef __cplusplus
namespace glider::hooks {
using MessageType = HookMessageType;
using Frame = HookFrame;
inline constexpr uint32_t kMostPayload = kHookMostPayload, kMostFrameBytes = kHookMostFrameBytes,
                          kMostEncodedBytes = kHookMostEncodedBytes;

inline uint32_t encodedBound(uint32_t payload) {
  return hookEncodedBound(payload);
}
inline uint32_t encodeFrame(const Frame& frame, uint8_t* out) {
  return hookEncodeFrame(&frame, out);
}

/// HookFrameDecoder.
class FrameDecoder {
 public:
  bool push(uint8_t byte) { return hookFrameDecoderPush(&decoder_, byte); }
  [[nodiscard]] const Frame& frame() const { return decoder_.frame; }
  [[nodiscard]] uint32_t badFrames() const { return decoder_.bad_frames; }
  [[nodiscard]] uint32_t doubles() const { return decoder_.doubles; }

 private:
  HookFrameDecoder decoder_;
};
}  // namespace glider::hooks
#endif

#endif
