// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/frame.h"

namespace glider::hooks {
namespace {

constexpr uint32_t kOverhead = 4;  // type, sequence, CRC

bool isKnownType(uint8_t number) {
  switch (static_cast<MessageType>(number)) {
#define MESSAGE(name, type_number, expects_answer) case MessageType::name:
#include "hooks/protocol/messages.def"
#undef MESSAGE
    return true;
  }
  return false;
}

/// COBS (Cheshire and Baker, 1999): every zero becomes the distance to the next one. `count` is at
/// most 254, so one code byte in front is all it adds.
uint32_t stuff(const uint8_t* bytes, uint32_t count, uint8_t* out) {
  uint32_t code_at = 0;
  uint32_t size = 1;
  for (uint32_t i = 0; i < count; ++i) {
    if (bytes[i] == 0) {
      out[code_at] = static_cast<uint8_t>(size - code_at);
      code_at = size++;
    } else {
      out[size++] = bytes[i];
    }
  }
  out[code_at] = static_cast<uint8_t>(size - code_at);
  return size;
}

}  // namespace

uint16_t crc16(const uint8_t* bytes, uint32_t count) {
  uint32_t crc = 0xFFFF;
  for (uint32_t i = 0; i < count; ++i) {
    crc ^= static_cast<uint32_t>(bytes[i]) << 8U;
    for (int bit = 0; bit < 8; ++bit) {
      crc = (crc & 0x8000U) != 0 ? (crc << 1U) ^ 0x1021U : crc << 1U;
    }
  }
  return static_cast<uint16_t>(crc);
}

uint32_t encodeFrame(const Frame& frame, uint8_t* out) {
  uint8_t plain[kMostFrameBytes];
  plain[0] = static_cast<uint8_t>(frame.type);
  plain[1] = frame.sequence;
  const uint32_t payload = frame.size < kMostPayload ? frame.size : kMostPayload;
  for (uint32_t i = 0; i < payload; ++i) {
    plain[2 + i] = frame.payload[i];
  }
  const uint16_t crc = crc16(plain, payload + 2);
  plain[payload + 2] = static_cast<uint8_t>(crc & 0xFFU);
  plain[payload + 3] = static_cast<uint8_t>(crc >> 8U);
  const uint32_t size = stuff(plain, payload + kOverhead, out);
  out[size] = 0;
  return size + 1;
}

bool FrameDecoder::push(uint8_t byte) {
  if (byte != 0) {
    if (count_ < kMostEncodedBytes) {
      bytes_[count_++] = byte;
    }
    return false;
  }
  if (count_ == 0) {
    return false;
  }
  const bool good = finish();
  count_ = 0;
  if (!good) {
    ++bad_frames_;
  }
  return good;
}

bool FrameDecoder::finish() {
  const uint32_t size = unstuff();
  if (size < kOverhead || size > kMostFrameBytes || !isKnownType(bytes_[0])) {
    return false;
  }
  const uint32_t crc = bytes_[size - 2] | static_cast<uint32_t>(bytes_[size - 1]) << 8U;
  if (crc != crc16(bytes_, size - 2)) {
    return false;
  }
  frame_.type = static_cast<MessageType>(bytes_[0]);
  frame_.sequence = bytes_[1];
  frame_.size = static_cast<uint8_t>(size - kOverhead);
  for (uint32_t i = 0; i < frame_.size; ++i) {
    frame_.payload[i] = bytes_[2 + i];
  }
  return true;
}

uint32_t FrameDecoder::unstuff() {
  if (count_ == kMostEncodedBytes) {
    return 0;
  }
  uint32_t size = 0;
  uint32_t at = 0;
  while (at < count_) {
    const uint32_t end = at + bytes_[at];
    if (end > count_) {
      return 0;
    }
    for (++at; at < end; ++at) {
      bytes_[size++] = bytes_[at];
    }
    // Between two groups stands a zero; a full group of 254 would have none, but no frame of ours
    // is that long.
    if (at < count_) {
      bytes_[size++] = 0;
    }
  }
  return size;
}

}  // namespace glider::hooks
