// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/extctl/pairs.h"

#include "hooks/extctl/port.h"
#include "hooks/protocol/decimal.h"

namespace glider::hooks::extctl {
namespace {

/// Numbers from here on are of no sensor, and need no more digits.
constexpr uint32_t kLargeIndex = kMostSensors;

Pair readPair(const char* text, uint32_t size) {
  Pair pair;
  uint32_t at = 0;
  for (; at < size && text[at] >= '0' && text[at] <= '9'; ++at) {
    pair.index = pair.index < kLargeIndex ? pair.index * 10 + static_cast<uint32_t>(text[at] - '0')
                                          : pair.index;
  }
  pair.good = at > 0 && at < size && text[at] == ':' &&
              readDecimal(text + at + 1, size - at - 1, &pair.value);
  return pair;
}

}  // namespace

bool PairReader::next(Pair* pair) {
  while (at_ < size_ && text_[at_] == ',') {
    ++at_;
  }
  const uint32_t begin = at_;
  while (at_ < size_ && text_[at_] != ',') {
    ++at_;
  }
  if (begin == at_) {
    return false;
  }
  *pair = readPair(text_ + begin, at_ - begin);
  return true;
}

}  // namespace glider::hooks::extctl
