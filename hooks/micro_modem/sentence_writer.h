// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/micro_modem/messages.h"

#include <stdint.h>

namespace glider::hooks::micro_modem {

/// A sentence that is being written: its name, its fields, then end().
class SentenceWriter {
 public:
  /// Writes into `bytes`, of which there are `capacity`. Begins with `$` and `name`.
  SentenceWriter(const char* name, char* bytes, uint32_t capacity);

  // Each writes a comma and a field.
  SentenceWriter& text(const char* text);
  /// Of the text of somebody else: one with what would begin or end a sentence is refused.
  SentenceWriter& text(const Text& text);
  /// A setting's name: one that is empty, too long or holds a comma is refused.
  SentenceWriter& name(const Text& name);
  /// One beyond its bounds is refused.
  SentenceWriter& whole(uint32_t lowest, uint32_t highest, uint32_t value);
  SentenceWriter& flag(bool value) { return whole(0, 1, value ? 1 : 0); }
  /// `HHMMSS`. One that no day has is refused.
  SentenceWriter& time(uint32_t time_s);
  /// Four hexadecimal digits. More than `most` is refused.
  SentenceWriter& bits(uint32_t most, uint32_t value);
  /// Pairs of hexadecimal digits.
  SentenceWriter& data(const Data& data);

  /// Adds the sum and the line end. Returns the size of the whole; 0 if it did not fit or something
  /// was refused.
  [[nodiscard]] uint32_t end();

 private:
  void put(char c);
  void digits(uint32_t value, uint32_t count);
  void hex(uint32_t value, uint32_t count);

  char* bytes_;
  uint32_t capacity_;
  uint32_t size_ = 0;
  uint8_t sum_ = 0;
  bool refused_ = false;
};

}  // namespace glider::hooks::micro_modem
