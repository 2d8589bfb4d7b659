// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_PROTOCOL_PAYLOAD_H
#define GLIDER_HOOKS_PROTOCOL_PAYLOAD_H

#include "hooks/protocol/bytes.h"
#include "hooks/protocol/frame.h"

/// How the encoders and decoders of messages begin and end.
GLIDER_HOOKS_BEGIN

/// Flags of Welcome and Tick; kept: of a Tick alone.
enum { kHookFlagVirtualTime = 4, kHookFlagKept = 8 };

GLIDER_INLINE HookByteWriter hookStartPayload(HookFrame* frame, HookMessageType type) {
  frame->type = type;
  frame->size = 0;
  return hookWriterTo(frame->payload, kHookMostPayload);
}

GLIDER_INLINE void hookFinishPayload(HookFrame* frame, const HookByteWriter* writer) {
  frame->size = (uint16_t)writer->size;
}

GLIDER_INLINE HookByteReader hookPayloadOf(const HookFrame* frame) {
  return hookReaderOf(frame->payload, frame->size);
}

GLIDER_HOOKS_END

#ifdef __cplusplus
namespace glider::hooks {

inline ByteWriter startPayload(Frame& frame, MessageType type) {
  frame.type = type;
  frame.size = 0;
  return {frame.payload, kMostPayload};
}
inline void finishPayload(Frame& frame, const ByteWriter& writer) {
  frame.size = static_cast<uint16_t>(writer.size());
}

}  // namespace glider::hooks
#endif

#endif
