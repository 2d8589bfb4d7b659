// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/reporter.h"

#include <antlr4-runtime.h>

namespace glider::frontend {

/// The parser's reaction to an unexpected token: reports in the pilot's terms what was expected,
/// skips to the next suitable keyword, and reports nothing more until that has been read.
class ErrorStrategy final : public antlr4::DefaultErrorStrategy {
 public:
  explicit ErrorStrategy(SyntaxReporter& reporter) : reporter_(reporter) {}

  /// Whether there was an unexpected token: then the tree is incomplete.
  [[nodiscard]] bool failed() const { return failed_; }

  void reportMatch(antlr4::Parser* parser) override;
  void reportError(antlr4::Parser* parser, const antlr4::RecognitionException& error) override;
  void recover(antlr4::Parser* parser, std::exception_ptr error) override;
  antlr4::Token* recoverInline(antlr4::Parser* parser) override;
  void sync(antlr4::Parser* parser) override;

 private:
  void complain(antlr4::Parser* parser, const antlr4::Token* found);
  void complainOfLine(antlr4::Parser* parser, size_t rule, const Lexeme& found);
  void complainOfPromise(size_t last, const Lexeme& found);
  void complainOfWord(antlr4::Parser* parser, const Lexeme& word);
  void complainOfItem(const Lexeme& found);
  void complainOfBody(antlr4::Parser* parser, const Lexeme& found);
  void complainOfSample(const Lexeme& found);
  void complainInRule(antlr4::Parser* parser, size_t rule, const Lexeme& found);
  void complainOfTransition(const Lexeme& before, const Lexeme& found);
  /// In a declaration, a block or a statement.
  void complainOfValue(antlr4::Parser* parser, const antlr4::Token* before, const Lexeme& found);
  void expected(std::string_view what, const Lexeme& found);
  void expectedValue(uint32_t keyword, const Lexeme& before, const Lexeme& found);
  void expectedText(const Lexeme& found);
  bool misspelled(const Lexeme& found, const std::vector<std::string_view>& keywords);

  SyntaxReporter& reporter_;
  bool failed_ = false;
};

}  // namespace glider::frontend
