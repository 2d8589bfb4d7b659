// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/lexeme.h"
#include "frontend/parse/reporter.h"

#include <map>
#include <optional>
#include <string_view>
#include <vector>

namespace glider::frontend {

/// First pass of repair: single tokens that are never valid (`;`, `=>`, `&`, `and`, foreign
/// characters, `5.`, texts without a closing quote). Each is reported and replaced by what was
/// meant, or dropped. Stops at a comment that is never closed.
class WordRepair {
 public:
  explicit WordRepair(SyntaxReporter& reporter) : reporter_(reporter) {}
  /// The repaired tokens; `cut` says whether an unclosed comment contains the rest of the file.
  std::vector<Lexeme> run(const std::vector<Lexeme>& lexemes);
  [[nodiscard]] bool cut() const { return cut_; }

 private:
  std::optional<Lexeme> one(const Lexeme& lexeme);
  static bool isOfPromise(const Lexeme& lexeme, const Lexeme& next);
  std::optional<Lexeme> foreign(const Lexeme& lexeme);
  [[nodiscard]] std::string_view wordAround(const Lexeme& lexeme) const;
  void semicolon(const Lexeme& lexeme, const Lexeme& next, std::vector<Lexeme>& out);
  void followOpen(const Lexeme& lexeme, const std::vector<Lexeme>& out);
  /// `3355.2 1825.4`: the number of tokens in the pair, which was reported and written as one
  /// token; otherwise 0.
  size_t barePair(const std::vector<Lexeme>& lexemes, size_t at, std::vector<Lexeme>& out);
  size_t several(const std::vector<Lexeme>& lexemes, size_t at, std::vector<Lexeme>& out);
  size_t decimalComma(const std::vector<Lexeme>& lexemes, size_t at, std::vector<Lexeme>& out);
  size_t quotedText(const std::vector<Lexeme>& lexemes, size_t at, std::vector<Lexeme>& out);
  [[nodiscard]] bool isOperatorInCapitals(const std::vector<Lexeme>& lexemes, size_t at,
                                          const std::vector<Lexeme>& out) const;
  Lexeme capitals(const Lexeme& lexeme);

  /// What `{` and `}` stand for; the types are 0 for nothing.
  struct Braces {
    std::string_view open;
    uint32_t open_type;
    std::string_view close;
    uint32_t close_type;
  };
  [[nodiscard]] bool isBrace(const Lexeme& lexeme) const;
  [[nodiscard]] size_t closingBrace(const std::vector<Lexeme>& lexemes, size_t at) const;
  [[nodiscard]] Braces bracesAfter(const std::vector<Lexeme>& out, uint32_t next) const;
  void brace(const std::vector<Lexeme>& lexemes, size_t at, std::vector<Lexeme>& out);

  [[nodiscard]] bool isRaisedPoint(const Lexeme& lexeme) const;
  static bool pointInName(const Lexeme& next, const std::vector<Lexeme>& out);
  bool pointForComma(const Lexeme& lexeme, const Lexeme& next, std::vector<Lexeme>& out);
  bool partOfToken(const Lexeme& lexeme, const Lexeme& next, std::vector<Lexeme>& out);
  void openString(const Lexeme& lexeme, std::vector<Lexeme>& out);
  Lexeme replaced(const Lexeme& lexeme, support::DiagnosticId id, uint32_t type);

  SyntaxReporter& reporter_;
  bool cut_ = false;
  /// The open parentheses and brackets, and whether each contains a function's arguments.
  std::vector<bool> open_;
  bool in_path_ = false;  ///< the last that was opened is a bracket
  uint32_t last_keyword_ = 0;
  std::map<size_t, uint32_t> closing_;  ///< a `}`, by its number, and the type of its meaning
  uint32_t name_end_ = UINT32_MAX;      ///< where a name with foreign letters continues
};

}  // namespace glider::frontend
