// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/recon/line_reader.h"
#include "hooks/recon/messages.h"

#include <stdint.h>

namespace glider::hooks::recon {

/// The most fields of a line, with the one that the `#` begins.
inline constexpr uint32_t kMostFields = 32;

/// The fields of a line: what its commas separate. An empty one at the end, before the `*`, is
/// none.
class Fields {
 public:
  /// A line with more fields has none.
  explicit Fields(const Line& line);

  [[nodiscard]] uint32_t count() const { return count_; }
  /// Empty for one that is not there.
  [[nodiscard]] Text at(uint32_t index) const { return index < count_ ? fields_[index] : Text(); }
  /// Whether the field is this text.
  [[nodiscard]] bool is(uint32_t index, const char* text) const {
    return index < count_ && fields_[index] == textOf(text);
  }

 private:
  Text fields_[kMostFields];
  uint32_t count_ = 0;
};

/// What follows the prefix; false if the text does not begin with it.
[[nodiscard]] bool takePrefix(Text* text, const char* prefix);

/// A finite number and nothing else; false otherwise.
[[nodiscard]] bool readNumber(const Text& text, double* value);

/// Digits with at most one point, that begin with a digit: no sign, no exponent. False otherwise.
[[nodiscard]] bool readUnsigned(const Text& text, double* value);

/// A number, or nothing, or "nan": that is kUnknown. False for anything else.
[[nodiscard]] bool readPerhaps(const Text& text, double* value);

/// Exactly `count` decimal digits at the begin; false if they are not there.
[[nodiscard]] bool takeDigits(Text* text, uint32_t count, double* value);

}  // namespace glider::hooks::recon
