// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

/// Sentences of the vehicle's port for a backseat driver: `$BODY*HH`, then a line end. HH is the
/// exclusive or of the bytes of BODY, in hexadecimal. Both ends of the line use this. No heap.
namespace glider::hooks::extctl {

/// The longest body that is read. Lines of 820 characters occur: a chunk of a file in base64.
inline constexpr uint32_t kMostBody = 1000;

/// The body with which a simulated vehicle begins a session: it waits for each answer. A real one
/// says `HI`.
inline constexpr char kVirtualTimeHello[] = "HI,virtual-time";

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
  /// Sentences that were begun and are wrong: another sum, cut off, too long.
  [[nodiscard]] uint32_t bad() const { return bad_; }

 private:
  enum class Part : uint8_t { Outside, Body, FirstDigit, SecondDigit };

  void begin();
  bool discard();
  void takeBody(uint8_t byte);

  char body_[kMostBody];
  uint32_t size_ = 0;
  uint32_t bad_ = 0;
  Part part_ = Part::Outside;
  uint8_t sum_ = 0;
  uint8_t told_ = 0;  ///< the sum that the sentence states
};

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
