// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/text.h"

#include <stdint.h>

/// Sentences as many instruments speak them: `$BODY*HH`. HH is the exclusive or of the bytes of
/// BODY, in hexadecimal. No heap.
namespace glider::hooks {

/// The longest body that is read. Lines of 820 characters occur: a chunk of a file in base64.
inline constexpr uint32_t kMostSentenceBody = 1000;

/// Finds the sentences in what arrives. What surrounds them is passed over: bytes before a `$`,
/// NULs, a sentence that is cut off by the next one.
class SentenceReader {
 public:
  /// Takes one byte. True when it ends a sentence whose sum is right: body() holds it until the
  /// next push. A sentence ends with the second digit of its sum; what follows may be CR, LF, both
  /// or another `$`.
  [[nodiscard]] bool push(uint8_t byte);
  [[nodiscard]] const char* body() const { return body_; }
  [[nodiscard]] uint32_t size() const { return size_; }
  [[nodiscard]] Text text() const { return {body_, size_}; }
  /// Sentences that were begun and are wrong: another sum, cut off, too long.
  [[nodiscard]] uint32_t bad() const { return bad_; }

 private:
  enum class Part : uint8_t { Outside, Body, FirstDigit, SecondDigit };

  void begin();
  bool discard();
  void takeBody(uint8_t byte);

  char body_[kMostSentenceBody];
  uint32_t size_ = 0;
  uint32_t bad_ = 0;
  Part part_ = Part::Outside;
  uint8_t sum_ = 0;
  uint8_t told_ = 0;  ///< the sum that the sentence states
};

}  // namespace glider::hooks
