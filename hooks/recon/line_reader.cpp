// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/recon/line_reader.h"

namespace glider::hooks::recon {
namespace {

/// `*`, two digits.
constexpr uint32_t kSum = 3;
constexpr uint8_t kNoDigit = 0xFF;

uint8_t digitOf(char digit) {
  return digit >= '0' && digit <= '9'   ? static_cast<uint8_t>(digit - '0')
         : digit >= 'A' && digit <= 'F' ? static_cast<uint8_t>(digit - 'A' + 10)
                                        : kNoDigit;
}

bool isPrintable(char c) {
  return c >= ' ' && c <= '~';
}

/// Where the line begins whose `*` is at `star`: the first `#` from which the sum is right, so that
/// a line which was cut off before it does not cost it. Returns `star` if there is none.
uint32_t beginOf(const char* bytes, uint32_t star, uint8_t sum) {
  uint32_t begin = star;
  auto found = static_cast<uint8_t>('*');
  for (uint32_t i = star; i-- > 0 && isPrintable(bytes[i]);) {
    found = static_cast<uint8_t>(found + static_cast<uint8_t>(bytes[i]));
    if (bytes[i] == '#' && found == sum) {
      begin = i;
    }
  }
  return begin;
}

}  // namespace

bool LineReader::push(uint8_t byte, Line* line) {
  if (byte == '\n') {
    return end(line);
  }
  if (size_ == kMostLine - 1) {  // no room for its line feed
    too_long_ = true;
    skipped_bytes_ += size_;
    size_ = 0;
  }
  if (too_long_) {
    ++skipped_bytes_;
  } else {
    bytes_[size_++] = static_cast<char>(byte);
  }
  return false;
}

/// What is held, and the line feed.
bool LineReader::end(Line* line) {
  const uint32_t size = size_;
  const bool too_long = too_long_;
  too_long_ = false;
  size_ = 0;
  const uint32_t shown = size != 0 && bytes_[size - 1] == '\r' ? size - 1 : size;
  if (!too_long && shown > kSum && bytes_[shown - kSum] == '*') {
    const uint32_t star = shown - kSum;
    const uint8_t high = digitOf(bytes_[star + 1]);
    const uint8_t low = digitOf(bytes_[star + 2]);
    const uint32_t begin = high == kNoDigit || low == kNoDigit
                               ? star
                               : beginOf(bytes_, star, static_cast<uint8_t>(high << 4 | low));
    if (begin != star) {
      skipped_bytes_ += begin;
      *line = {bytes_ + begin, star - begin};
      return true;
    }
  }
  skipped_bytes_ += size + 1;
  return false;
}

}  // namespace glider::hooks::recon
