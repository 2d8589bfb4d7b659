// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/source_manager.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace glider::frontend {

/// A token: its type in the grammar and its bytes. A token that repair has inserted is empty.
struct Lexeme {
  uint32_t type = 0;
  uint32_t begin = 0;
  uint32_t end = 0;
};

/// Larger files, in bytes, are not read.
inline constexpr size_t kLargestFile = 8U << 20U;

/// The text that tokens refer to.
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

/// True if the file defines a state called `word`, which was then meant where a value is not
/// allowed.
bool isStateName(const Source& source, std::string_view word);

/// The tokens of a file, one of type end-of-file last. `start` skips a byte order mark.
std::vector<Lexeme> lex(std::string_view text, size_t start);
/// The tokens of `source`, without its byte order mark.
std::vector<Lexeme> lex(const Source& source);

/// Groups of token types, as bits; repair asks for them several times for each token.
namespace detail {
inline constexpr size_t kMostTypes = 192;
enum Group : uint8_t { kHardKeyword = 1, kSoftKeyword = 2, kName = 4, kAnyName = 8 };
extern const std::array<uint8_t, kMostTypes> kGroups;
inline bool isIn(uint32_t type, Group group) {
  return type < kMostTypes && (kGroups[type] & group) != 0;
}
}  // namespace detail

inline bool isHardKeyword(uint32_t type) {
  return detail::isIn(type, detail::kHardKeyword);
}
/// Whether it may be used where the grammar says `name` (including soft keywords).
inline bool isName(uint32_t type) {
  return detail::isIn(type, detail::kName);
}
/// Whether it may be used where the grammar says `anyName` (including units).
inline bool isAnyName(uint32_t type) {
  return detail::isIn(type, detail::kAnyName);
}
/// Whether it is a word of the language in some places and a name elsewhere, such as `in`.
inline bool isSoftKeyword(uint32_t type) {
  return detail::isIn(type, detail::kSoftKeyword);
}
/// All hard keywords, as written.
const std::vector<std::string_view>& hardKeywords();
/// The type of the hard keyword spelled `word`; 0 if there is none.
uint32_t keywordType(std::string_view word);
/// Whether `word` is hard keyword `meant` with one letter missing, added, changed or swapped, and
/// no other hard keyword is as near: certain enough for a fix that is applied automatically.
bool isSlip(std::string_view word, std::string_view meant);
/// The token for messages: "`begin`", "the number `5`", "the end of the file".
std::string describe(const Source& source, const Lexeme& lexeme);
/// The same for a token type: "a name", "`)`".
std::string describeType(uint32_t type);

}  // namespace glider::frontend
