// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/recon/fields.h"

#include "hooks/protocol/decimal.h"
#include "hooks/protocol/numbers.h"

namespace glider::hooks::recon {
namespace {

Text from(const Text& text, uint32_t begin) {
  return {text.bytes + begin, text.size - begin};
}

}  // namespace

Fields::Fields(const Line& line) {
  uint32_t begin = 0;
  uint32_t count = 0;
  for (uint32_t i = 0; i <= line.size; ++i) {
    const bool last = i == line.size;
    if (last ? begin == i : line.text[i] != ',') {
      continue;
    }
    if (count == kMostFields) {
      return;
    }
    fields_[count++] = {line.text + begin, i - begin};
    begin = i + 1;
  }
  count_ = count;
}

bool takePrefix(Text* text, const char* prefix) {
  const Text expected = textOf(prefix);
  if (text->size < expected.size || !(Text{text->bytes, expected.size} == expected)) {
    return false;
  }
  *text = from(*text, expected.size);
  return true;
}

bool readNumber(const Text& text, double* value) {
  return readDecimal(text.bytes, text.size, value) && hookIsFinite(*value);
}

bool readUnsigned(const Text& text, double* value) {
  for (uint32_t i = 0; i < text.size; ++i) {
    const char c = text.bytes[i];
    if ((c < '0' || c > '9') && (c != '.' || i == 0)) {
      return false;
    }
  }
  return readNumber(text, value);
}

bool readPerhaps(const Text& text, double* value) {
  *value = kUnknown;
  return text.size == 0 || readDecimal(text.bytes, text.size, value);
}

bool takeDigits(Text* text, uint32_t count, double* value) {
  if (text->size < count) {
    return false;
  }
  double number = 0;
  for (uint32_t i = 0; i < count; ++i) {
    const char digit = text->bytes[i];
    if (digit < '0' || digit > '9') {
      return false;
    }
    number = number * 10 + (digit - '0');
  }
  *text = from(*text, count);
  *value = number;
  return true;
}

}  // namespace glider::hooks::recon
