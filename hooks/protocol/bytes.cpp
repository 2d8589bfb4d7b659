// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/bytes.h"

namespace glider::hooks {

void ByteWriter::bits(uint64_t value, uint32_t width) {
  if (capacity_ - size_ < width) {
    fits_ = false;
    return;
  }
  for (uint32_t i = 0; i < width; ++i) {
    bytes_[size_++] = static_cast<uint8_t>(value >> (8U * i));
  }
}

uint64_t ByteReader::bits(uint32_t width) {
  if (count_ - at_ < width) {
    good_ = false;
    at_ = count_;
    return 0;
  }
  uint64_t value = 0;
  for (uint32_t i = 0; i < width; ++i) {
    value |= static_cast<uint64_t>(bytes_[at_++]) << (8U * i);
  }
  return value;
}

void ByteReader::skip(uint32_t count) {
  if (count_ - at_ < count) {
    good_ = false;
    at_ = count_;
    return;
  }
  at_ += count;
}

}  // namespace glider::hooks
