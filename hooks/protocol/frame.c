// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/frame.h"

#include "hooks/protocol/c_library.h"
#include "hooks/protocol/crc.h"

enum { kHead = 2 };  // type, sequence

static bool isKnownType(uint8_t number) {
  switch (number) {
#define MESSAGE(name, type_number, expects_answer) case kHookMessageType##name:
#include "hooks/protocol/messages.def"
    return true;
    default:
      return false;
  }
}

/// Bytes of the CRC. Beacon and Hello have the same frame in every version, so that two sides with
/// different versions can report them to each other.
static uint32_t checkBytes(HookMessageType type) {
  return type == kHookMessageTypeBeacon || type == kHookMessageTypeHello ? 2 : 4;
}

static uint32_t checkOf(HookMessageType type, const uint8_t* head, const uint8_t* payload,
                        uint32_t size) {
  return checkBytes(type) == 2
             ? hookCrc16(payload, size, hookCrc16(head, kHead, kHookCrc16Start))
             : hookCrc32c(payload, size, hookCrc32c(head, kHead, kHookCrc32cStart));
}

/// COBS (Cheshire and Baker 1999, doi 10.1109/90.769765): every zero becomes the distance to the
/// next one, at most 254 bytes away.
typedef struct Stuffer {
  uint8_t* out;
  uint32_t code_at;
  uint32_t size;
} Stuffer;

enum { kFullGroup = 255 };  // with its code byte

static void closeGroup(Stuffer* stuffer) {
  stuffer->out[stuffer->code_at] = (uint8_t)(stuffer->size - stuffer->code_at);
  stuffer->code_at = stuffer->size++;
}

static void stuff(Stuffer* stuffer, uint8_t byte) {
  if (stuffer->size - stuffer->code_at == kFullGroup) {
    closeGroup(stuffer);
  }
  if (byte == 0) {
    closeGroup(stuffer);
  } else {
    stuffer->out[stuffer->size++] = byte;
  }
}

/// Ends the frame; returns its bytes.
static uint32_t endStuffing(Stuffer* stuffer) {
  closeGroup(stuffer);
  stuffer->out[stuffer->code_at] = 0;
  return stuffer->size;
}

uint32_t hookEncodedBound(uint32_t payload) {
  const uint32_t plain = payload + kHookMostFrameBytes - kHookMostPayload;
  return plain + plain / 254 + 2;
}

uint32_t hookEncodeFrame(const HookFrame* frame, uint8_t* out) {
  const uint8_t head[kHead] = {(uint8_t)frame->type, frame->sequence};
  const uint32_t size = frame->size < kHookMostPayload ? frame->size : kHookMostPayload;
  const uint32_t check = checkOf(frame->type, head, frame->payload, size);
  Stuffer stuffer = {out, 0, 1};
  for (uint32_t i = 0; i < kHead; ++i) {
    stuff(&stuffer, head[i]);
  }
  for (uint32_t i = 0; i < size; ++i) {
    stuff(&stuffer, frame->payload[i]);
  }
  for (uint32_t i = 0; i < checkBytes(frame->type); ++i) {
    stuff(&stuffer, (uint8_t)(check >> (8U * i)));
  }
  return endStuffing(&stuffer);
}

static void begin(HookFrameDecoder* decoder) {
  decoder->count = 0;
  decoder->group_left = 0;
  decoder->zero_follows = false;
  decoder->begun = false;
  decoder->too_long = false;
}

static void append(HookFrameDecoder* decoder, uint8_t byte) {
  if (decoder->count < kHookMostFrameBytes) {
    decoder->bytes[decoder->count++] = byte;
  } else {
    decoder->too_long = true;
  }
}

static void unstuff(HookFrameDecoder* decoder, uint8_t byte) {
  decoder->begun = true;
  if (decoder->group_left > 0) {
    --decoder->group_left;
    append(decoder, byte);
    return;
  }
  if (decoder->zero_follows) {
    append(decoder, 0);
  }
  decoder->group_left = (uint8_t)(byte - 1);
  decoder->zero_follows = byte != 255;  // a full group is not followed by a zero
}

/// Whether the bytes are a good frame; its CRC into `check`.
static bool isGood(const HookFrameDecoder* decoder, uint32_t* check) {
  const uint8_t* bytes = decoder->bytes;
  if (decoder->group_left > 0 || decoder->too_long || !isKnownType(bytes[0])) {
    return false;
  }
  const HookMessageType type = bytes[0];
  const uint32_t width = checkBytes(type);
  if (decoder->count < kHead + width || decoder->count - kHead - width > kHookMostPayload) {
    return false;
  }
  const uint32_t size = decoder->count - width;
  *check = checkOf(type, bytes, bytes + kHead, size - kHead);
  uint32_t told = 0;
  for (uint32_t i = 0; i < width; ++i) {
    told |= (uint32_t)bytes[size + i] << (8U * i);
  }
  return told == *check;
}

static bool finish(HookFrameDecoder* decoder) {
  uint32_t check = 0;
  if (!isGood(decoder, &check)) {
    ++decoder->bad_frames;
    return false;
  }
  HookFrame* frame = &decoder->frame;
  const HookMessageType type = decoder->bytes[0];
  const uint16_t size = (uint16_t)(decoder->count - kHead - checkBytes(type));
  if (decoder->any && check == decoder->last_check && type == frame->type &&
      decoder->bytes[1] == frame->sequence && size == frame->size) {
    ++decoder->doubles;
    return false;
  }
  decoder->any = true;
  decoder->last_check = check;
  frame->type = type;
  frame->sequence = decoder->bytes[1];
  frame->size = size;
  memcpy(frame->payload, decoder->bytes + kHead, size);
  return true;
}

bool hookFrameDecoderPush(HookFrameDecoder* decoder, uint8_t byte) {
  if (byte != 0) {
    unstuff(decoder, byte);
    return false;
  }
  const bool good = decoder->begun && finish(decoder);
  begin(decoder);
  return good;
}
