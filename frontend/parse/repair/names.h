// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/lexeme.h"
#include "frontend/parse/reporter.h"

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace glider::frontend {

/// The pass of repair between words and structure: names that are not one word, in the headers of
/// missions, states, profiles and routes (`state go home`, `state hold-deep`, `state look:`,
/// `state "look"`) and in `goto` and `call`. Each is reported once and becomes one token, so that
/// the `begin` after it is read as what it is.
class NameRepair {
 public:
  explicit NameRepair(SyntaxReporter& reporter) : reporter_(reporter), source_(reporter.source()) {}

  std::vector<Lexeme> run(const std::vector<Lexeme>& lexemes);
  /// Whether a name was left whose correct form the text does not contain: resolving names would
  /// report each of its uses.
  [[nodiscard]] bool guessed() const { return guessed_; }

 private:
  /// The tokens that were written as a name.
  struct WrittenName {
    size_t begin = 0;
    size_t end = 0;             ///< past the last
    std::vector<Lexeme> words;  ///< letters, digits and `_` in one piece
    [[nodiscard]] bool found() const { return end > begin; }
  };

  void gatherNames();
  [[nodiscard]] WrittenName slipAfter(size_t keyword) const;
  [[nodiscard]] WrittenName headerAfter(size_t keyword) const;
  [[nodiscard]] WrittenName missionAfter(size_t keyword) const;
  [[nodiscard]] WrittenName targetAfter(size_t keyword) const;
  [[nodiscard]] size_t tokensOfLine(size_t from) const;
  [[nodiscard]] bool sameLine(const Lexeme& a, const Lexeme& b) const;
  [[nodiscard]] std::vector<Lexeme> wordsIn(size_t begin, size_t end) const;
  [[nodiscard]] std::string joined(const std::vector<Lexeme>& words) const;

  /// The name that was meant.
  struct IntendedName {
    std::string name;
    bool certain = false;
  };
  [[nodiscard]] IntendedName meantBy(size_t keyword, const WrittenName& slip) const;
  Lexeme report(size_t keyword, const WrittenName& slip);

  SyntaxReporter& reporter_;
  const Source& source_;
  std::vector<Lexeme> in_;
  std::set<std::string, std::less<>> used_;  ///< after `goto` and `call`, or after `flightprofile`
  std::set<std::string, std::less<>> defined_;  ///< states, profiles and routes with a good name
  std::set<std::string, std::less<>> joined_;   ///< what the headers with a slip would become
  bool guessed_ = false;
};

}  // namespace glider::frontend
