// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// The words of a file with the comments and line breaks between them.
namespace glider::frontend::formatting {

/// The comments that begin on one line of the source.
struct CommentRow {
  std::vector<std::string> comments;  ///< without spaces at the ends of their lines
  size_t newlines_before = 0;         ///< since the token or comment before
  bool open_ended = false;            ///< the last one runs to the end of its line

  [[nodiscard]] std::string text() const;
};

struct Token {
  std::string_view text;
  std::vector<CommentRow> rows;  ///< the comments before it
  size_t newlines_before = 0;    ///< since the last of these, or the token before
  size_t depth = 0;              ///< number of open brackets around it; a bracket is outside itself
  bool name = false;             ///< used as a name
  bool ends_value = false;       ///< an expression may end with it
  bool tight = false;            ///< no space before it
  bool unit_part = false;        ///< of a unit or a type: `/` and `m` of `degC/m`
  bool operation = false;        ///< an operator between two values

  [[nodiscard]] bool is(std::string_view word) const { return text == word; }
  /// Whether it is the word with which a member of a state begins, and no name.
  [[nodiscard]] bool isSample() const { return is("sample") && !name; }
  /// Whether the source breaks the line somewhere before it.
  [[nodiscard]] bool broken() const;
  /// Whether it opens a bracket.
  [[nodiscard]] bool opens() const { return is("(") || is("["); }
  [[nodiscard]] bool closes() const { return is(")") || is("]"); }
};

/// The tokens of `text`, which has no syntax errors; an empty one at the end has the comments after
/// the last. They refer to `text`.
std::vector<Token> readTokens(std::string_view text);

}  // namespace glider::frontend::formatting
