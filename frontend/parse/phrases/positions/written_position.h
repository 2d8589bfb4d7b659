// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace glider::frontend {

/// Half of a position in any form that charts, pilots and other tools use: `39 10.5 N`,
/// `39°10.5'N`, `39d10.5m n`, `39-10.5N`, `N 39 10.5`, `39.175 North`.
struct WrittenHalf {
  enum class Form : uint8_t { Ours, Other };
  Form form = Form::Other;  ///< `Ours`: as the language writes it
  bool certain = true;      ///< it can only be read in one way
  bool minutes_over_60 = false;
  bool sign = false;   ///< a degree sign, a dash or the like is between its numbers
  bool comma = false;  ///< a number in it has a decimal comma
  bool word = false;   ///< `North`
  bool small = false;  ///< `n`
  bool letter_first = false;
  int numbers = 1;
  double degrees = 0;     ///< all of it, without the letter's sign
  double whole = 0;       ///< its first number
  double minutes = 0;     ///< its second number
  std::string digits;     ///< as the language writes it, without the letter: "39 10.5"
  char letter = 0;        ///< N, S, E or W
  size_t begin = 0;       ///< where it begins in the text, and what belongs to it
  size_t end = 0;         ///< past it
  size_t number = 0;      ///< where its first number begins
  size_t number_end = 0;  ///< past its last number
  size_t letter_at = 0;

  [[nodiscard]] bool latitude() const { return letter == 'N' || letter == 'S'; }
  /// "39 10.5 N".
  [[nodiscard]] std::string better() const { return digits + " " + letter; }
};

/// The half of a position that begins at `at` in `text`, all on one line; empty if there is none.
/// The letter comes last, or first if `letter_first`.
std::optional<WrittenHalf> writtenHalf(std::string_view text, size_t at, bool letter_first);

/// "39 10.5": the numbers of half a position in any form without its letter, as the language writes
/// them; empty if `text` is anything else.
std::optional<std::string> positionDigits(std::string_view text);

}  // namespace glider::frontend
