// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/micro_modem/fields.h"

namespace glider::hooks::micro_modem {
namespace {

constexpr uint32_t kNoDigit = 16;

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

uint32_t hexDigit(char c) {
  const auto lower = static_cast<char>(c | 0x20);
  return isDigit(c)                     ? static_cast<uint32_t>(c - '0')
         : lower >= 'a' && lower <= 'f' ? static_cast<uint32_t>(lower - 'a' + 10)
                                        : kNoDigit;
}

/// `count` decimal digits; false if one of them is none.
bool readDigits(const char* bytes, uint32_t count, uint32_t* value) {
  uint32_t number = 0;
  for (uint32_t i = 0; i < count; ++i) {
    if (!isDigit(bytes[i])) {
      return false;
    }
    number = number * 10 + static_cast<uint32_t>(bytes[i] - '0');
  }
  *value = number;
  return true;
}

bool isSettingName(const Text& text) {
  for (uint32_t i = 0; i < text.size; ++i) {
    const char c = text.bytes[i];
    const bool letter = (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
    if (!letter && !isDigit(c)) {
      return false;
    }
  }
  return text.size != 0 && text.size <= kMostSettingName;
}

}  // namespace

Text Fields::take() {
  require(!ended_);
  uint32_t size = 0;
  while (size < rest_.size && rest_.bytes[size] != ',') {
    ++size;
  }
  const Text field{rest_.bytes, size};
  ended_ = size == rest_.size;
  const uint32_t used = ended_ ? size : size + 1;
  rest_ = {rest_.bytes + used, rest_.size - used};
  return field;
}

Fields& Fields::require(bool good) {
  good_ = good_ && good;
  return *this;
}

Fields& Fields::is(const char* text) {
  return require(take() == textOf(text));
}

Fields& Fields::isEither(const char* text, const char* other) {
  const Text field = take();
  return require(field == textOf(text) || field == textOf(other));
}

Fields& Fields::whole(uint32_t lowest, uint32_t highest, uint32_t* value) {
  constexpr uint32_t kMostDigits = 5;
  const Text field = take();
  return require(field.size != 0 && field.size <= kMostDigits &&
                 readDigits(field.bytes, field.size, value) && *value >= lowest &&
                 *value <= highest);
}

Fields& Fields::flag(bool* value) {
  const Text field = take();
  *value = field == textOf("1");
  return require(*value || field == textOf("0"));
}

Fields& Fields::name(Text* name) {
  *name = take();
  return require(isSettingName(*name));
}

Fields& Fields::time(uint32_t* time_s) {
  constexpr uint32_t kDigits = 6;
  const Text field = take();
  uint32_t hours = 0, minutes = 0, seconds = 0;
  if (field.size != kDigits || !readDigits(field.bytes, 2, &hours) ||
      !readDigits(field.bytes + 2, 2, &minutes) || !readDigits(field.bytes + 4, 2, &seconds)) {
    return require(false);
  }
  *time_s = (hours * 60 + minutes) * 60 + (seconds == 60 ? 59 : seconds);
  return require(hours < 24 && minutes < 60 && seconds <= 60);
}

Fields& Fields::bits(uint32_t most, uint32_t* value) {
  constexpr uint32_t kDigits = 4;
  const Text field = take();
  uint32_t number = 0;
  bool good = field.size == kDigits;
  for (uint32_t i = 0; good && i < kDigits; ++i) {
    const uint32_t digit = hexDigit(field.bytes[i]);
    good = digit != kNoDigit;
    number = number << 4 | digit;
  }
  *value = number;
  return require(good && number <= most);
}

Fields& Fields::data(Data* data) {
  const Text field = take();
  data->size = 0;
  if (field.size % 2 != 0 || field.size / 2 > kMostFrameBytes) {
    return require(false);
  }
  for (uint32_t i = 0; i < field.size; i += 2) {
    const uint32_t high = hexDigit(field.bytes[i]);
    const uint32_t low = hexDigit(field.bytes[i + 1]);
    if (high == kNoDigit || low == kNoDigit) {
      return require(false);
    }
    data->bytes[data->size++] = static_cast<uint8_t>(high << 4 | low);
  }
  return *this;
}

Fields& Fields::rest(Text* text) {
  require(!ended_);
  *text = rest_;
  rest_ = {rest_.bytes + rest_.size, 0};
  ended_ = true;
  return *this;
}

}  // namespace glider::hooks::micro_modem
