// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/lexeme.h"

#include <antlr4-runtime.h>

#include <memory>
#include <string>
#include <vector>

namespace glider::frontend {

/// Passes repaired tokens to ANTLR's parser.
class LexemeSource final : public antlr4::TokenSource {
 public:
  explicit LexemeSource(const std::vector<Lexeme>& lexemes) : lexemes_(lexemes) {}

  std::unique_ptr<antlr4::Token> nextToken() override {
    const Lexeme& lexeme = lexemes_[next_];
    next_ += next_ + 1 < lexemes_.size() ? 1U : 0U;
    const bool last = lexeme.type == static_cast<uint32_t>(antlr4::Token::EOF);
    auto token = std::make_unique<antlr4::CommonToken>(last ? antlr4::Token::EOF : lexeme.type);
    token->setStartIndex(lexeme.begin);
    token->setStopIndex(lexeme.end);  // one past the last byte: empty tokens exist
    return token;
  }
  size_t getLine() const override { return 0; }
  size_t getCharPositionInLine() override { return 0; }
  antlr4::CharStream* getInputStream() override { return nullptr; }
  std::string getSourceName() override { return "mission"; }
  antlr4::TokenFactory<antlr4::CommonToken>* getTokenFactory() override {
    return antlr4::CommonTokenFactory::DEFAULT.get();
  }

 private:
  const std::vector<Lexeme>& lexemes_;
  size_t next_ = 0;
};

/// The bytes of a token that came from a LexemeSource.
inline Lexeme lexemeOf(const antlr4::Token* token) {
  return {static_cast<uint32_t>(token->getType()), static_cast<uint32_t>(token->getStartIndex()),
          static_cast<uint32_t>(token->getStopIndex())};
}

}  // namespace glider::frontend
