// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/frame.h"

#include "hooks/protocol/crc.h"

namespace glider::hooks {
namespace {

constexpr uint32_t kHead = 2;  // type, sequence

bool isKnownType(uint8_t number) {
  switch (static_cast<MessageType>(number)) {
#define MESSAGE(name, type_number, expects_answer) case MessageType::name:
#include "hooks/protocol/messages.def"
#undef MESSAGE
    return true;
  }
  return false;
}

/// Bytes of the CRC. Beacon and Hello have the same frame in every version, so that two sides with
/// different versions can report them to each other.
uint32_t checkBytes(MessageType type) {
  return type == MessageType::Beacon || type == MessageType::Hello ? 2 : 4;
}

uint32_t checkOf(MessageType type, const uint8_t* head, const uint8_t* payload, uint32_t size) {
  return checkBytes(type) == 2 ? crc16(payload, size, crc16(head, kHead))
                               : crc32c(payload, size, crc32c(head, kHead));
}

/// COBS (Cheshire and Baker 1999, doi 10.1109/90.769765): every zero becomes the distance to the
/// next one, at most 254 bytes away.
class Stuffer {
 public:
  explicit Stuffer(uint8_t* out) : out_(out) {}

  void put(uint8_t byte) {
    if (size_ - code_at_ == kFullGroup) {
      closeGroup();
    }
    if (byte == 0) {
      closeGroup();
    } else {
      out_[size_++] = byte;
    }
  }

  /// Ends the frame; returns its bytes.
  uint32_t finish() {
    closeGroup();
    out_[code_at_] = 0;
    return size_;
  }

 private:
  static constexpr uint32_t kFullGroup = 255;  // with its code byte

  void closeGroup() {
    out_[code_at_] = static_cast<uint8_t>(size_ - code_at_);
    code_at_ = size_++;
  }

  uint8_t* out_;
  uint32_t code_at_ = 0;
  uint32_t size_ = 1;
};

}  // namespace

uint32_t encodedBound(uint32_t payload) {
  const uint32_t plain = payload + kMostFrameBytes - kMostPayload;
  return plain + plain / 254 + 2;
}

uint32_t encodeFrame(const Frame& frame, uint8_t* out) {
  const uint8_t head[kHead] = {static_cast<uint8_t>(frame.type), frame.sequence};
  const uint32_t size = frame.size < kMostPayload ? frame.size : kMostPayload;
  const uint32_t check = checkOf(frame.type, head, frame.payload, size);
  Stuffer stuffer(out);
  for (const uint8_t byte : head) {
    stuffer.put(byte);
  }
  for (uint32_t i = 0; i < size; ++i) {
    stuffer.put(frame.payload[i]);
  }
  for (uint32_t i = 0; i < checkBytes(frame.type); ++i) {
    stuffer.put(static_cast<uint8_t>(check >> (8U * i)));
  }
  return stuffer.finish();
}

bool FrameDecoder::push(uint8_t byte) {
  if (byte != 0) {
    unstuff(byte);
    return false;
  }
  const bool good = begun_ && finish();
  begin();
  return good;
}

void FrameDecoder::begin() {
  count_ = 0;
  group_left_ = 0;
  zero_follows_ = false;
  begun_ = false;
  too_long_ = false;
}

void FrameDecoder::unstuff(uint8_t byte) {
  begun_ = true;
  if (group_left_ > 0) {
    --group_left_;
    append(byte);
    return;
  }
  if (zero_follows_) {
    append(0);
  }
  group_left_ = static_cast<uint8_t>(byte - 1);
  zero_follows_ = byte != 255;  // a full group is not followed by a zero
}

void FrameDecoder::append(uint8_t byte) {
  if (count_ < kMostFrameBytes) {
    bytes_[count_++] = byte;
  } else {
    too_long_ = true;
  }
}

bool FrameDecoder::isGood(uint32_t* check) const {
  if (group_left_ > 0 || too_long_ || !isKnownType(bytes_[0])) {
    return false;
  }
  const auto type = static_cast<MessageType>(bytes_[0]);
  const uint32_t width = checkBytes(type);
  if (count_ < kHead + width || count_ - kHead - width > kMostPayload) {
    return false;
  }
  const uint32_t size = count_ - width;
  *check = checkOf(type, bytes_, bytes_ + kHead, size - kHead);
  uint32_t told = 0;
  for (uint32_t i = 0; i < width; ++i) {
    told |= static_cast<uint32_t>(bytes_[size + i]) << (8U * i);
  }
  return told == *check;
}

bool FrameDecoder::finish() {
  uint32_t check = 0;
  if (!isGood(&check)) {
    ++bad_frames_;
    return false;
  }
  const auto type = static_cast<MessageType>(bytes_[0]);
  const auto size = static_cast<uint16_t>(count_ - kHead - checkBytes(type));
  if (any_ && check == last_check_ && type == frame_.type && bytes_[1] == frame_.sequence &&
      size == frame_.size) {
    ++doubles_;
    return false;
  }
  any_ = true;
  last_check_ = check;
  frame_.type = type;
  frame_.sequence = bytes_[1];
  frame_.size = size;
  __builtin_memcpy(frame_.payload, bytes_ + kHead, size);
  return true;
}

}  // namespace glider::hooks
