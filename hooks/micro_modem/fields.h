// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/micro_modem/messages.h"

#include <stdint.h>

namespace glider::hooks::micro_modem {

/// The fields of a sentence, from the first to the last. Each function takes one field, and refuses
/// all that follow once one was not what it should be.
class Fields {
 public:
  explicit Fields(const Text& body) : rest_(body) {}

  /// This text.
  Fields& is(const char* text);
  /// One of two texts.
  Fields& isEither(const char* text, const char* other);
  /// A decimal number without a sign, in at most five digits.
  Fields& whole(uint32_t lowest, uint32_t highest, uint32_t* value);
  /// `0` or `1`.
  Fields& flag(bool* value);
  /// The name of a setting.
  Fields& name(Text* name);
  /// Six digits `HHMMSS`, as seconds since midnight. A leap second is the one before it.
  Fields& time(uint32_t* time_s);
  /// Four hexadecimal digits.
  Fields& bits(uint32_t most, uint32_t* value);
  /// Pairs of hexadecimal digits.
  Fields& data(Data* data);
  /// All that is left, commas included.
  Fields& rest(Text* text);
  /// Whether all fields were what they should be, and none is left.
  [[nodiscard]] bool end() const { return good_ && ended_; }

 private:
  Text take();
  Fields& require(bool good);

  Text rest_;
  bool good_ = true;
  bool ended_ = false;  ///< the last field is taken
};

}  // namespace glider::hooks::micro_modem
