// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/frame_reader.h"

enum { kMostBytes = 8192 };  // in one call

HookFrameReading hookFrameReaderNext(HookFrameReader* reader, const GliderByteStream* stream) {
  for (uint32_t looked = 0; looked < kMostBytes; ++looked) {
    if (reader->at >= reader->count) {
      const int32_t got = stream->read(stream->self, reader->bytes, kHookReaderBytes);
      if (got <= 0) {
        return got < 0 ? kHookFrameReadingClosed : kHookFrameReadingNothing;
      }
      reader->at = 0;
      reader->count = (uint32_t)got < kHookReaderBytes ? (uint32_t)got : kHookReaderBytes;
    }
    if (hookFrameDecoderPush(&reader->decoder, reader->bytes[reader->at++])) {
      return kHookFrameReadingFrame;
    }
  }
  return kHookFrameReadingNothing;
}
