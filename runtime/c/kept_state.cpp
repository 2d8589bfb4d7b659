// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/c/kept_state.h"

#include <string.h>

namespace glider::runtime {

bool KeptState::add(void* bytes, uint32_t count) {
  if (count == 0) {
    declared_ = true;
    return true;
  }
  if (bytes == nullptr || count_ == kMostPieces || count > kMostBytes - size_) {
    return false;
  }
  declared_ = true;
  pieces_[count_++] = {static_cast<uint8_t*>(bytes), count};
  size_ += count;
  return true;
}

void KeptState::save(uint8_t* out) const {
  for (uint32_t i = 0; i < count_; ++i) {
    memcpy(out, pieces_[i].bytes, pieces_[i].count);
    out += pieces_[i].count;
  }
}

void KeptState::restore(const uint8_t* from) const {
  for (uint32_t i = 0; i < count_; ++i) {
    memcpy(pieces_[i].bytes, from, pieces_[i].count);
    from += pieces_[i].count;
  }
}

}  // namespace glider::runtime
