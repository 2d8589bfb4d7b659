// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/text/lexer.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace glider::ir::text {
namespace {

constexpr size_t kLongestBad = 20;

bool digit(char c) {
  return c >= '0' && c <= '9';
}
bool letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool wordPart(char c) {
  return letter(c) || digit(c);
}
bool numberPart(char c) {
  return wordPart(c) || c == '.' || c == '+' || c == '-';
}
bool blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

/// The byte that `\xHH` at the start of `text` represents, or -1.
int escaped(std::string_view text) {
  int value = -1;
  if (text.size() < 4 || !text.starts_with("\\x")) {
    return -1;
  }
  auto [end, error] = std::from_chars(text.data() + 2, text.data() + 4, value, 16);
  return error == std::errc() && end == text.data() + 4 && value >= 0 ? value : -1;
}

}  // namespace

void Lexer::skipBlanks() {
  while (place_ < text_.size()) {
    if (text_[place_] == '#') {
      place_ = std::min(text_.find('\n', place_), text_.size());
    } else if (blank(text_[place_])) {
      ++place_;
    } else {
      return;
    }
  }
}

Token Lexer::take(TokenKind kind, size_t end) {
  Token token{kind,
              std::string(text_.substr(place_, end - place_)),
              {file_, static_cast<uint32_t>(place_), static_cast<uint32_t>(end)}};
  place_ = end;
  return token;
}

Token Lexer::string() {
  const size_t begin = place_;
  std::string value;
  size_t end = begin + 1;
  while (at(end) != '"') {
    const char c = at(end);
    const int byte = c == '\\' ? escaped(text_.substr(end)) : c;
    if (c < 0x20 || c > 0x7e || byte < 0) {  // a string must end on its line
      return take(TokenKind::Bad, std::min({begin + kLongestBad, end + 1, text_.size()}));
    }
    value += static_cast<char>(byte);
    end += c == '\\' ? 4 : 1;
  }
  Token token = take(TokenKind::String, end + 1);
  token.text = value;
  return token;
}

Token Lexer::next() {
  skipBlanks();
  if (place_ >= text_.size()) {
    return take(TokenKind::End, text_.size());
  }
  const char c = text_[place_];
  auto run = [&](size_t from, auto part) {
    while (from < text_.size() && part(text_[from])) {
      ++from;
    }
    return from;
  };
  if (letter(c)) {
    return take(TokenKind::Word, run(place_, wordPart));
  }
  if (digit(c) || c == '-' || c == '+' || c == '.') {
    return take(TokenKind::Number, run(place_, numberPart));
  }
  if (c == '%' && wordPart(at(place_ + 1))) {
    Token token = take(TokenKind::Name, run(place_ + 1, wordPart));
    token.text.erase(0, 1);
    return token;
  }
  if (c == '"') {
    return string();
  }
  return take(std::string_view("():,=").contains(c) ? TokenKind::Mark : TokenKind::Bad, place_ + 1);
}

std::string describe(const Token& token) {
  switch (token.kind) {
    case TokenKind::End:
      return "the end of the text";
    case TokenKind::Bad:
      return token.text.front() == '"' ? "an unterminated string" : "an unexpected character";
    case TokenKind::String:
      return "a string";
    case TokenKind::Name:
      return fmt::format("`%{}`", token.text.substr(0, kLongestBad));
    case TokenKind::Word:
    case TokenKind::Number:
    case TokenKind::Mark:
      break;
  }
  return fmt::format("`{}`", token.text.substr(0, kLongestBad));
}

}  // namespace glider::ir::text
