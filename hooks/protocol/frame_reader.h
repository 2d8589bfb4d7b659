// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_PROTOCOL_FRAME_READER_H
#define GLIDER_HOOKS_PROTOCOL_FRAME_READER_H

#include "hooks/protocol/frame.h"
#include "hooks/transport/byte_stream.h"

#ifdef __cplusplus
enum class HookFrameReading : uint8_t {
#define FRAME_READING(name) name,
#include "hooks/protocol/messages.def"
};
#else
typedef uint8_t HookFrameReading;
enum {
#define FRAME_READING(name) kHookFrameReading##name,
#include "hooks/protocol/messages.def"
};
#endif

GLIDER_HOOKS_BEGIN

enum { kHookReaderBytes = 256 };

/// Splits a stream into whole frames, one at a time; bytes after a frame wait for the next call.
/// It begins with all bytes zero.
typedef struct HookFrameReader {
  HookFrameDecoder decoder;
  uint8_t bytes[kHookReaderBytes] GLIDER_IS({});
  uint32_t at GLIDER_IS(0);
  uint32_t count GLIDER_IS(0);  ///< of the bytes that it holds: more only if its memory is broken
} HookFrameReader;

/// The next whole frame, if all its bytes have arrived: it is in decoder.frame until the next call.
/// Reads a bounded number of bytes, so that a stream full of noise cannot block its reader.
HookFrameReading hookFrameReaderNext(HookFrameReader* reader, const GliderByteStream* stream);

GLIDER_HOOKS_END

#ifdef __cplusplus
namespace glider::hooks {

/// HookFrameReader.
class FrameReader {
 public:
  using Result = HookFrameReading;
  static constexpr uint32_t kBytes = kHookReaderBytes;

  Result next(const GliderByteStream& stream) { return hookFrameReaderNext(&reader_, &stream); }
  [[nodiscard]] const Frame& frame() const { return reader_.decoder.frame; }
  [[nodiscard]] uint32_t badFrames() const { return reader_.decoder.bad_frames; }
  /// How many bytes it holds: at most kBytes, unless its memory is broken.
  [[nodiscard]] uint32_t held() const { return reader_.count; }

 private:
  HookFrameReader reader_;
};

}  // namespace glider::hooks
#endif

#endif
