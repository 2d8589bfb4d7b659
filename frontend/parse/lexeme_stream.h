// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/lexeme.h"

#include <antlr4-runtime.h>

#include <algorithm>
#include <string>
#include <vector>

namespace glider::frontend {

/// A lexeme as ANTLR's parser sees it, a fifth of the size of ANTLR's own tokens. Its text is taken
/// from the source, by its place.
class LexemeToken final : public antlr4::Token {
 public:
  LexemeToken(const Lexeme& lexeme, size_t index)
      : lexeme_(lexeme), index_(static_cast<uint32_t>(index)) {}

  size_t getType() const override {
    return lexeme_.type == static_cast<uint32_t>(antlr4::Token::EOF) ? antlr4::Token::EOF
                                                                     : lexeme_.type;
  }
  size_t getStartIndex() const override { return lexeme_.begin; }
  size_t getStopIndex() const override {
    return lexeme_.end;  // one past the last byte: empty tokens exist
  }
  size_t getTokenIndex() const override { return index_; }
  std::string getText() const override { return {}; }
  size_t getLine() const override { return 0; }
  size_t getCharPositionInLine() const override { return 0; }
  size_t getChannel() const override { return antlr4::Token::DEFAULT_CHANNEL; }
  antlr4::TokenSource* getTokenSource() const override { return nullptr; }
  antlr4::CharStream* getInputStream() const override { return nullptr; }
  std::string toString() const override { return {}; }

 private:
  Lexeme lexeme_;
  uint32_t index_;
};

/// Passes repaired tokens to ANTLR's parser. They are all there from the start, so nothing is
/// fetched, and no channel is skipped.
class LexemeStream final : public antlr4::TokenStream {
 public:
  /// The last of `lexemes` is the end of the file.
  explicit LexemeStream(const std::vector<Lexeme>& lexemes) {
    tokens_.reserve(lexemes.size());
    for (const Lexeme& lexeme : lexemes) {
      tokens_.emplace_back(lexeme, tokens_.size());
    }
  }

  antlr4::Token* LT(ssize_t k) override {
    if (k < 0) {
      const auto back = static_cast<size_t>(-k);
      return back > at_ ? nullptr : &tokens_[at_ - back];
    }
    return k == 0 ? nullptr : &ahead(static_cast<size_t>(k) - 1);
  }
  size_t LA(ssize_t k) override {
    const antlr4::Token* token = LT(k);
    return token == nullptr ? 0 : token->getType();
  }
  /// The type of the token that is `k` tokens after the current one.
  [[nodiscard]] size_t typeAhead(size_t k) { return ahead(k).getType(); }
  void consume() override { at_ += at_ + 1 < tokens_.size() ? 1U : 0U; }
  size_t index() override { return at_; }
  void seek(size_t index) override { at_ = std::min(index, tokens_.size() - 1); }
  size_t size() override { return tokens_.size(); }
  antlr4::Token* get(size_t index) const override { return &tokens_[index]; }
  ssize_t mark() override { return 0; }
  void release(ssize_t) override {}
  std::string getSourceName() const override { return "mission"; }
  antlr4::TokenSource* getTokenSource() const override { return nullptr; }
  std::string getText(const antlr4::misc::Interval&) override { return {}; }
  std::string getText() override { return {}; }
  std::string getText(antlr4::RuleContext*) override { return {}; }
  std::string getText(antlr4::Token*, antlr4::Token*) override { return {}; }

 private:
  LexemeToken& ahead(size_t k) { return tokens_[std::min(at_ + k, tokens_.size() - 1)]; }

  mutable std::vector<LexemeToken> tokens_;
  size_t at_ = 0;
};

/// The bytes of a token of a LexemeStream.
inline Lexeme lexemeOf(const antlr4::Token* token) {
  return {static_cast<uint32_t>(token->getType()), static_cast<uint32_t>(token->getStartIndex()),
          static_cast<uint32_t>(token->getStopIndex())};
}

}  // namespace glider::frontend
