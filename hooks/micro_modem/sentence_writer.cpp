// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/micro_modem/sentence_writer.h"

namespace glider::hooks::micro_modem {

SentenceWriter::SentenceWriter(const char* name, char* bytes, uint32_t capacity)
    : bytes_(bytes), capacity_(capacity) {
  put('$');
  sum_ = 0;
  for (; *name != '\0'; ++name) {
    put(*name);
  }
}

void SentenceWriter::put(char c) {
  if (size_ < capacity_) {
    bytes_[size_] = c;
  }
  sum_ ^= static_cast<uint8_t>(c);
  ++size_;
}

void SentenceWriter::digits(uint32_t value, uint32_t count) {
  uint32_t unit = 1;
  for (uint32_t i = 1; i < count; ++i) {
    unit *= 10;
  }
  for (; unit != 0; unit /= 10) {
    put(static_cast<char>('0' + value / unit % 10));
  }
}

void SentenceWriter::hex(uint32_t value, uint32_t count) {
  while (count-- != 0) {
    put("0123456789ABCDEF"[value >> 4 * count & 0xF]);
  }
}

SentenceWriter& SentenceWriter::text(const char* text) {
  return this->text(textOf(text));
}

SentenceWriter& SentenceWriter::text(const Text& text) {
  put(',');
  for (uint32_t i = 0; i < text.size; ++i) {
    const char c = text.bytes[i];
    refused_ = refused_ || c < ' ' || c > '~' || c == '$' || c == '*';
    put(c);
  }
  return *this;
}

SentenceWriter& SentenceWriter::name(const Text& name) {
  for (uint32_t i = 0; i < name.size; ++i) {
    const char c = name.bytes[i];
    refused_ =
        refused_ || !((c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'));
  }
  refused_ = refused_ || name.size == 0 || name.size > kMostSettingName;
  return text(name);
}

SentenceWriter& SentenceWriter::whole(uint32_t lowest, uint32_t highest, uint32_t value) {
  refused_ = refused_ || value < lowest || value > highest;
  uint32_t count = 1;
  for (uint32_t left = value / 10; left != 0; left /= 10) {
    ++count;
  }
  put(',');
  digits(value, count);
  return *this;
}

SentenceWriter& SentenceWriter::time(uint32_t time_s) {
  constexpr uint32_t kDay = 86400;
  refused_ = refused_ || time_s >= kDay;
  put(',');
  digits(time_s / 3600, 2);
  digits(time_s / 60 % 60, 2);
  digits(time_s % 60, 2);
  return *this;
}

SentenceWriter& SentenceWriter::bits(uint32_t most, uint32_t value) {
  refused_ = refused_ || value > most;
  put(',');
  hex(value, 4);
  return *this;
}

SentenceWriter& SentenceWriter::data(const Data& data) {
  put(',');
  if (data.size > kMostFrameBytes) {
    refused_ = true;
    return *this;
  }
  for (uint32_t i = 0; i < data.size; ++i) {
    hex(data.bytes[i], 2);
  }
  return *this;
}

uint32_t SentenceWriter::end() {
  const uint8_t sum = sum_;
  put('*');
  hex(sum, 2);
  put('\r');
  put('\n');
  return size_ <= capacity_ && !refused_ ? size_ : 0;
}

}  // namespace glider::hooks::micro_modem
