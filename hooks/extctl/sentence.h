// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/sentence_reader.h"

#include <stdint.h>

/// Sentences of the vehicle's port for a backseat driver: `$BODY*HH`, then a line end. HH is the
/// exclusive or of the bytes of BODY, in hexadecimal. Both ends of the line use this. No heap.
namespace glider::hooks::extctl {

using hooks::SentenceReader;
inline constexpr uint32_t kMostBody = kMostSentenceBody;

/// The body with which a simulated vehicle begins a session: it waits for each answer. A real one
/// says `HI`.
inline constexpr char kVirtualTimeHello[] = "HI,virtual-time";

/// A sentence that is being written: its body, then end().
class SentenceWriter {
 public:
  /// Writes into `bytes`, of which there are `capacity`.
  SentenceWriter(char* bytes, uint32_t capacity) : bytes_(bytes), capacity_(capacity) { put('$'); }

  void put(char c);
  void put(const char* text);
  void put(uint32_t number);
  /// With six decimals.
  void put(double value);
  /// Adds the sum and the line end. Returns the size of the whole, 0 if it did not fit.
  uint32_t end();
  /// What the sentence has taken so far.
  [[nodiscard]] uint32_t size() const { return size_; }

 private:
  char* bytes_;
  uint32_t capacity_;
  uint32_t size_ = 0;
  uint8_t sum_ = 0;
};

/// Bytes that end() adds.
inline constexpr uint32_t kSentenceEnd = 5;

}  // namespace glider::hooks::extctl
