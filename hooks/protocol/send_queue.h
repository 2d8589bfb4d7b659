// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_PROTOCOL_SEND_QUEUE_H
#define GLIDER_HOOKS_PROTOCOL_SEND_QUEUE_H

#include "hooks/protocol/frame.h"
#include "hooks/transport/byte_stream.h"

GLIDER_HOOKS_BEGIN

enum { kHookSendQueueBytes = 2048 };

/// Encoded frames on their way to a stream that may accept only a part at a time. Frames are queued
/// whole or not at all. It begins with all bytes zero.
typedef struct HookSendQueue {
  uint8_t bytes[kHookSendQueueBytes] GLIDER_IS({});
  uint32_t end GLIDER_IS(0);  ///< how many bytes wait: more only if its memory is broken
} HookSendQueue;

/// False, with nothing queued, when there is no room for `frame`.
bool hookSendQueueAdd(HookSendQueue* queue, const HookFrame* frame);
/// Writes as much as `stream` accepts. False when the stream is closed or failed.
bool hookSendQueueFlush(HookSendQueue* queue, const GliderByteStream* stream);

GLIDER_HOOKS_END

#ifdef __cplusplus
namespace glider::hooks {

/// HookSendQueue.
class SendQueue {
 public:
  static constexpr uint32_t kCapacity = kHookSendQueueBytes;

  bool add(const Frame& frame) { return hookSendQueueAdd(&queue_, &frame); }
  bool flush(const GliderByteStream& stream) { return hookSendQueueFlush(&queue_, &stream); }
  [[nodiscard]] uint32_t room() const { return kCapacity - queue_.end; }
  [[nodiscard]] bool empty() const { return queue_.end == 0; }
  /// How many bytes wait: at most kCapacity, unless its memory is broken.
  [[nodiscard]] uint32_t held() const { return queue_.end; }

 private:
  HookSendQueue queue_;
};

}  // namespace glider::hooks
#endif

#endif
