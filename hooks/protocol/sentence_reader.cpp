// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/sentence_reader.h"

namespace glider::hooks {
namespace {

constexpr uint8_t kNoDigit = 0xFF;

uint8_t digitOf(uint8_t byte) {
  const uint8_t lower = byte | 0x20;
  return byte >= '0' && byte <= '9'     ? static_cast<uint8_t>(byte - '0')
         : lower >= 'a' && lower <= 'f' ? static_cast<uint8_t>(lower - 'a' + 10)
                                        : kNoDigit;
}

}  // namespace

void SentenceReader::begin() {
  part_ = Part::Body;
  size_ = 0;
  sum_ = 0;
}

bool SentenceReader::discard() {
  ++bad_;
  part_ = Part::Outside;
  return false;
}

void SentenceReader::takeBody(uint8_t byte) {
  if (byte == '*') {
    part_ = Part::FirstDigit;
  } else if (byte < ' ' || byte > '~' || size_ == kMostSentenceBody) {
    discard();
  } else {
    body_[size_++] = static_cast<char>(byte);
    sum_ ^= byte;
  }
}

bool SentenceReader::push(uint8_t byte) {
  if (byte == '$') {  // no body has one: the sentence before, if any, was cut off
    bad_ += part_ == Part::Outside ? 0 : 1;
    begin();
    return false;
  }
  switch (part_) {
    case Part::Outside:
      break;
    case Part::Body:
      takeBody(byte);
      break;
    case Part::FirstDigit:
    case Part::SecondDigit: {
      const uint8_t digit = digitOf(byte);
      if (digit == kNoDigit) {
        return discard();
      }
      if (part_ == Part::FirstDigit) {
        told_ = static_cast<uint8_t>(digit << 4);
        part_ = Part::SecondDigit;
        return false;
      }
      part_ = Part::Outside;
      return (told_ | digit) == sum_ || discard();
    }
  }
  return false;
}

}  // namespace glider::hooks
