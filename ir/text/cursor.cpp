// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/text/cursor.h"

#include "support/diagnostics/ids/ir_text.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace glider::ir::text {

Cursor::Cursor(std::string_view text, uint32_t file, support::DiagnosticEngine& diagnostics)
    : lexer_(text, file), diagnostics_(diagnostics), token_(lexer_.next()) {}

Token Cursor::take() {
  Token taken = token_;
  if (!failed_) {
    last_end_ = taken.range.end;
    token_ = lexer_.next();
  }
  return taken;
}

bool Cursor::accept(std::string_view word) {
  const bool found = token_.isWord(word);
  if (found) {
    take();
  }
  return found;
}

bool Cursor::accept(char mark) {
  const bool found = token_.isMark(mark);
  if (found) {
    take();
  }
  return found;
}

support::SourceRange Cursor::expect(std::string_view word) {
  const support::SourceRange range = token_.range;
  if (!accept(word)) {
    failExpecting(fmt::format("`{}`", word));
  }
  return range;
}

void Cursor::expect(char mark) {
  if (!accept(mark)) {
    failExpecting(fmt::format("`{}`", mark));
  }
}

std::string Cursor::name(std::string_view what) {
  if (token_.kind != TokenKind::Word && token_.kind != TokenKind::String) {
    failExpecting(what);
    return {};
  }
  return take().text;
}

Token Cursor::nameToken(std::string_view what) {
  Token token = token_;
  token.text = name(what);
  return token;
}

double Cursor::number(bool infinite) {
  // "inf" without a sign is a word to the lexer.
  if (token_.kind != TokenKind::Number && !(infinite && token_.isWord("inf"))) {
    failExpecting("a number");
    return 0;
  }
  const Token token = take();
  const char* const end = token.text.data() + token.text.size();
  double value = 0;
  const auto [stop, error] = std::from_chars(token.text.data(), end, value);
  if (error != std::errc() || stop != end || std::isnan(value) ||
      (!infinite && std::isinf(value))) {
    fail(support::diagnostics::irBadNumber, token.range, token.text,
         "a number that a double can hold");
    return 0;
  }
  return value;
}

int64_t Cursor::integer(int64_t lowest, int64_t highest) {
  if (token_.kind != TokenKind::Number) {
    failExpecting("a number");
    return lowest;
  }
  const Token token = take();
  const char* const end = token.text.data() + token.text.size();
  int64_t value = 0;
  const auto [stop, error] = std::from_chars(token.text.data(), end, value);
  if (error != std::errc() || stop != end || value < lowest || value > highest) {
    fail(support::diagnostics::irBadNumber, token.range, token.text,
         fmt::format("a whole number from {} to {}", lowest, highest));
    return lowest;
  }
  return value;
}

Type Cursor::type() {
  const Token token = token_;
  const std::string word = name("a type");
  if (word == "latitude") {
    return {TypeKind::Latitude, {}};
  }
  if (word == "longitude") {
    return {TypeKind::Longitude, {}};
  }
  if (auto dimension = support::findDimension(word)) {
    return {TypeKind::Quantity, *dimension};
  }
  Type type;
  if (word != "dim") {
    fail(support::diagnostics::irUnknownName, token.range, "type", word);
    return type;
  }
  expect('(');
  for (size_t i = 0; i < type.dimension.exponents.size(); ++i) {
    if (i > 0) {
      expect(',');
    }
    type.dimension.exponents.at(i) = static_cast<int8_t>(integer(-12, 12));
  }
  expect(')');
  return type;
}

void Cursor::failExpecting(std::string_view what) {
  fail(support::diagnostics::irUnexpected, token_.range, what, describe(token_));
}

}  // namespace glider::ir::text
