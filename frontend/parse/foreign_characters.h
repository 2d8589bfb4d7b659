// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/lexeme.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// Characters outside ASCII, and what they were meant as.
namespace glider::frontend {

/// A character that word processors and web pages put in place of ASCII, and the token that was
/// meant (0: none).
struct Lookalike {
  std::string_view text;
  std::string_view meant;
  uint32_t type;
};

/// Characters that look like a space or like nothing, by their names in Unicode.
struct Blank {
  std::string_view text;
  std::string_view name;
  bool wide;  ///< it separates words
};

/// The row of `text`, which may be several of the same character; null: it is none.
const Blank* blankOf(std::string_view text);
const Lookalike* lookalikeOf(std::string_view text);
bool isLookalike(std::string_view text);
/// "character `é`", for messages.
std::string characterText(std::string_view text);
/// Quotation marks of word processors.
bool isQuote(std::string_view text);

/// The length of the UTF-8 character at `at`; 0 if there is none (RFC 3629, table 3-7 of the
/// Unicode standard).
size_t characterLength(std::string_view text, size_t at);
/// Whether `text` is whole characters in UTF-8.
bool isUtf8(std::string_view text);

/// `für` in the letters of a name: "fuer"; empty if a letter has no usual spelling.
std::string plainSpelling(std::string_view word);

/// The tokens with runs of foreign characters apart: blanks, signs with a meaning of their own, and
/// the rest.
std::vector<Lexeme> separateForeign(const std::vector<Lexeme>& lexemes, const Source& source);

}  // namespace glider::frontend
