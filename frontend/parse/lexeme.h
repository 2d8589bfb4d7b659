// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/source_manager.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace glider::frontend {

/// A token: its type in the grammar and its bytes. One that repair put in is empty.
struct Lexeme {
  uint32_t type = 0;
  uint32_t begin = 0;
  uint32_t end = 0;
};

/// Files with more bytes are not read.
inline constexpr size_t kLargestFile = 8U << 20U;

/// The text that tokens are of.
struct Source {
  const support::SourceManager& sources;
  uint32_t file;

  [[nodiscard]] std::string_view text() const { return sources.text(file); }
  [[nodiscard]] std::string_view text(const Lexeme& lexeme) const {
    return text().substr(lexeme.begin, lexeme.end - lexeme.begin);
  }
  [[nodiscard]] support::SourceRange range(const Lexeme& lexeme) const {
    return {file, lexeme.begin, lexeme.end};
  }
};

/// True if the file defines a state called `word`: what was meant where no value fits.
bool isStateName(const Source& source, std::string_view word);

/// The tokens of a file, one of type end-of-file last. `start` skips a byte order mark.
std::vector<Lexeme> lex(std::string_view text, size_t start);
/// The tokens of `source`, without its byte order mark.
std::vector<Lexeme> lex(const Source& source);

bool isHardKeyword(uint32_t type);
/// May stand where the grammar says `name` (soft keywords included).
bool isName(uint32_t type);
/// May stand where the grammar says `anyName` (units included).
bool isAnyName(uint32_t type);
/// A word of the language in some places and a name elsewhere, such as `in`.
bool isSoftKeyword(uint32_t type);
/// All hard keywords, as written.
const std::vector<std::string_view>& hardKeywords();
/// The type of the hard keyword spelled `word`; 0 if it is none.
uint32_t keywordType(std::string_view word);
/// Whether `word` is hard keyword `meant` with one letter missing, added, changed or swapped, and
/// no other hard keyword is as near: certain enough for a fix that nobody looks at.
bool isSlip(std::string_view word, std::string_view meant);
/// The token as a pilot would say it: "`begin`", "the number `5`", "the end of the file".
std::string describe(const Source& source, const Lexeme& lexeme);
/// A token type likewise: "a name", "`)`".
std::string describeType(uint32_t type);

}  // namespace glider::frontend
