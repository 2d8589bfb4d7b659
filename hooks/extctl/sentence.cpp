// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/extctl/sentence.h"

#include "hooks/protocol/decimal.h"

namespace glider::hooks::extctl {

void SentenceWriter::put(char c) {
  if (size_ < capacity_) {
    bytes_[size_] = c;
  }
  sum_ ^= size_ == 0 ? 0 : static_cast<uint8_t>(c);
  ++size_;
}

void SentenceWriter::put(const char* text) {
  for (; *text != '\0'; ++text) {
    put(*text);
  }
}

void SentenceWriter::put(uint32_t number) {
  constexpr uint32_t kMostDigits = 10;
  char digits[kMostDigits];
  uint32_t count = 0;
  do {
    digits[count++] = static_cast<char>('0' + number % 10);
    number /= 10;
  } while (number != 0);
  while (count != 0) {
    put(digits[--count]);
  }
}

void SentenceWriter::put(double value) {
  char text[kMostDecimal];
  const uint32_t count = writeDecimal(value, text);
  for (uint32_t i = 0; i < count; ++i) {
    put(text[i]);
  }
}

uint32_t SentenceWriter::end() {
  static constexpr char kHex[] = "0123456789abcdef";
  const uint8_t sum = sum_;
  put('*');
  put(kHex[sum >> 4]);
  put(kHex[sum & 0xF]);
  put('\r');
  put('\n');
  return size_ <= capacity_ ? size_ : 0;
}

}  // namespace glider::hooks::extctl
