// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/lexeme.h"
#include "frontend/parse/reporter.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace glider::frontend {

/// The deepest nesting of blocks and parentheses, and the greatest number of operators in an
/// expression: everything after the parser may then recurse over the tree.
inline constexpr size_t kDeepestNesting = 200;
inline constexpr size_t kMostOperators = 1000;

/// The part of repair that checks the text between keywords: parentheses, `=` and `==`, units,
/// missing commas, and the limits.
class ValueRepair {
 public:
  ValueRepair(SyntaxReporter& reporter, std::vector<Lexeme>& out)
      : reporter_(reporter), source_(reporter.source()), out_(out) {}

  /// Takes `t`, which is not a keyword; `next` comes after it. False if a limit was exceeded: the
  /// rest is not worth reading.
  bool take(Lexeme t, const Lexeme& next);
  /// Closes everything that is open before the keyword `found`, which begins a new expression.
  void keyword(const Lexeme& found);
  [[nodiscard]] bool inParentheses() const { return !parentheses_.empty(); }
  [[nodiscard]] bool inSensors() const { return in_sensors_; }
  /// Whether something was read as what it may not mean.
  [[nodiscard]] bool guessed() const { return guessed_; }

 private:
  struct Parenthesis {
    Lexeme opener;
    bool lists = false;    ///< values with commas between them
    size_t operators = 0;  ///< of the item being read
    size_t most = 0;       ///< of the items before it
    bool doubtful =
        false;  ///< what is between two of its values was reported, and left to the pilot
  };

  bool open(const Lexeme& t);
  bool close(const Lexeme& t);
  void endOfItem();
  void dropComma(const Lexeme& found);
  [[nodiscard]] bool isLetterOfPosition(size_t end) const;
  bool countOperator(const Lexeme& t);
  Lexeme equals(Lexeme t);
  [[nodiscard]] bool namesArgument() const;
  [[nodiscard]] bool typesParameter() const;
  bool unknownUnit(const Lexeme& t, const Lexeme& next);
  void missingComma(const Lexeme& t, const Lexeme& next);
  void reportMissingComma(const Lexeme& before, const Lexeme& t, const Lexeme& next);
  [[nodiscard]] std::string insteadOfComma(const Lexeme& before, const Lexeme& t,
                                           const Lexeme& next) const;
  [[nodiscard]] std::string valueOf(const Lexeme& number, const Lexeme& next) const;
  [[nodiscard]] bool listsValues() const;
  [[nodiscard]] bool declares() const;
  [[nodiscard]] bool belongTogether(const Lexeme& t, const Lexeme& next) const;
  [[nodiscard]] uint32_t previous() const { return out_.empty() ? 0 : out_.back().type; }
  void insert(uint32_t type);
  [[nodiscard]] std::string_view lastValue() const;
  [[nodiscard]] size_t comparisonInside() const;
  void closeBefore(const Lexeme& found);

  SyntaxReporter& reporter_;
  const Source& source_;
  std::vector<Lexeme>& out_;
  std::vector<Parenthesis> parentheses_;
  size_t operators_ = 0;
  bool assignable_ = false;  ///< the `=` of `const`, `param`, `var` or `set` is still to come
  bool in_sensors_ = false;
  bool names_arguments_ = false;  ///< a profile, route or state is used
  bool guessed_ = false;
};

}  // namespace glider::frontend
