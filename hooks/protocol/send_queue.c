// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/send_queue.h"

bool hookSendQueueAdd(HookSendQueue* queue, const HookFrame* frame) {
  if (kHookSendQueueBytes - queue->end < hookEncodedBound(frame->size)) {
    return false;
  }
  queue->end += hookEncodeFrame(frame, queue->bytes + queue->end);
  return true;
}

/// Removes the first `count` bytes; all of them if a stream claims to have taken more than there
/// were.
static void takeAway(HookSendQueue* queue, uint32_t count) {
  const uint32_t rest = count < queue->end ? queue->end - count : 0;
  for (uint32_t i = 0; i < rest; ++i) {
    queue->bytes[i] = queue->bytes[count + i];
  }
  queue->end = rest;
}

bool hookSendQueueFlush(HookSendQueue* queue, const GliderByteStream* stream) {
  uint32_t next = 0;
  int32_t taken = 1;
  while (next < queue->end && taken > 0) {
    taken = stream->write(stream->self, queue->bytes + next, queue->end - next);
    next += taken > 0 ? (uint32_t)taken : 0;
  }
  takeAway(queue, next);
  return taken >= 0;
}
