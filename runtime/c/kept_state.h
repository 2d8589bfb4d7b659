// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

/// The C program's own state, which its checkpoints keep (keepState of runtime/c/glider.h).
namespace glider::runtime {

class KeptState {
 public:
  static constexpr uint32_t kMostPieces = 16;
  static constexpr uint32_t kMostBytes = 2048;

  /// Also keeps these bytes. False, with none of them kept, if they are too many.
  bool add(void* bytes, uint32_t count);
  /// True if the program has declared what it keeps, even if that is nothing.
  [[nodiscard]] bool isDeclared() const { return declared_; }
  /// False only if its memory is broken.
  [[nodiscard]] bool isSound() const { return count_ <= kMostPieces && size_ <= kMostBytes; }
  /// Bytes in all.
  [[nodiscard]] uint32_t size() const { return size_; }
  /// Copies all pieces, one after another, to `out`, and from there back to their places.
  void save(uint8_t* out) const;
  void restore(const uint8_t* from) const;

 private:
  struct Piece {
    uint8_t* bytes;
    uint32_t count;
  };
  Piece pieces_[kMostPieces] = {};
  uint32_t count_ = 0;
  uint32_t size_ = 0;
  bool declared_ = false;
};

}  // namespace glider::runtime
