// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/source_range.h"

#include <cstdint>
#include <string>

namespace glider::ir::text {

enum class TokenKind : uint8_t { Word, String, Number, Name, Mark, Bad, End };

struct Token {
  TokenKind kind = TokenKind::End;
  std::string text;  ///< a String's or Name's without quotes, escapes and `%`
  support::SourceRange range;

  [[nodiscard]] bool isWord(std::string_view word) const {
    return kind == TokenKind::Word && text == word;
  }
  [[nodiscard]] bool isMark(char mark) const {
    return kind == TokenKind::Mark && text.front() == mark;
  }
};

/// Splits the text form of a mission into tokens: words, quoted strings, numbers, `%` names and the
/// marks ( ) : , =. Spaces, line ends and comments (`#` to the end of the line) separate them.
/// Accepts any bytes; what is not part of a token is a Bad token of at most 20 bytes.
class Lexer {
 public:
  Lexer(std::string_view text, uint32_t file) : text_(text), file_(file) {}
  /// The next token; always End after the end of the text.
  Token next();

 private:
  [[nodiscard]] char at(size_t place) const { return place < text_.size() ? text_[place] : '\0'; }
  void skipBlanks();
  Token take(TokenKind kind, size_t end);
  Token string();

  std::string_view text_;
  uint32_t file_;
  size_t place_ = 0;
};

/// For messages: "`goto`", "the end of the text".
std::string describe(const Token& token);

}  // namespace glider::ir::text
