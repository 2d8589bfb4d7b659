// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/recon/line_writer.h"

#include "hooks/protocol/decimal.h"
#include "hooks/protocol/numbers.h"
#include "hooks/recon/line_reader.h"

namespace glider::hooks::recon {

LineWriter& LineWriter::put(char c) {
  if (size_ < capacity_) {
    bytes_[size_] = c;
  }
  sum_ = static_cast<uint8_t>(sum_ + static_cast<uint8_t>(c));
  ++size_;
  return *this;
}

LineWriter& LineWriter::put(const char* text) {
  for (; *text != '\0'; ++text) {
    put(*text);
  }
  return *this;
}

LineWriter& LineWriter::put(const Text& text) {
  for (uint32_t i = 0; i < text.size; ++i) {
    const char c = text.bytes[i];
    refused_ = refused_ || c < ' ' || c > '~' || c == '#' || c == '*';
    put(c);
  }
  return *this;
}

LineWriter& LineWriter::put(double value) {
  refused_ = refused_ || !hookIsFinite(value);
  char text[kMostDecimal];
  const uint32_t count = writeDecimal(value, text);
  for (uint32_t i = 0; i < count; ++i) {
    put(text[i]);
  }
  return *this;
}

LineWriter& LineWriter::field(const char* prefix, double value) {
  put(',').put(prefix);
  return hookIsFinite(value) ? put(value) : *this;
}

LineWriter& LineWriter::digits(uint32_t value, uint32_t count) {
  uint32_t unit = 1;
  for (uint32_t i = 1; i < count; ++i) {
    unit *= 10;
  }
  for (; unit != 0; unit /= 10) {
    put(static_cast<char>('0' + value / unit % 10));
  }
  return *this;
}

LineWriter& LineWriter::whole(uint32_t value) {
  uint32_t count = 1;
  for (uint32_t rest = value / 10; rest != 0; rest /= 10) {
    ++count;
  }
  return digits(value, count);
}

uint32_t LineWriter::end(const char* before) {
  static constexpr char kHex[] = "0123456789ABCDEF";
  put(before);
  const uint8_t sum = sum_;
  put(kHex[sum >> 4]).put(kHex[sum & 0xF]).put('\n');
  return size_ <= capacity_ && size_ <= kMostLine && !refused_ ? size_ : 0;
}

}  // namespace glider::hooks::recon
