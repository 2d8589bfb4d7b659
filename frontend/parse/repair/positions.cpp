// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/repair/positions.h"

#include "frontend/parse/token_kinds.h"

#include <cstdlib>
#include <string_view>

namespace glider::frontend {
namespace {

/// The file may end before that token.
bool isLetter(const std::vector<Lexeme>& lexemes, size_t at) {
  return at < lexemes.size() && lexemes[at].type == GliderLexer::COMPASS;
}

constexpr double kMinutes = 60;

bool areDigits(std::string_view text) {
  return text.find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace

std::optional<Lexeme> degreesAndMinutes(const std::vector<Lexeme>& lexemes, size_t at,
                                        const Source& source) {
  constexpr size_t kTokens = 3;
  constexpr size_t kMostDegrees = 3;  // digits
  if (at + kTokens > lexemes.size() || lexemes[at].type != GliderLexer::NUMBER ||
      lexemes[at + 1].type != GliderLexer::NUMBER || !isLetter(lexemes, at + 2)) {
    return std::nullopt;
  }
  const std::string_view degrees = source.text(lexemes[at]);
  const std::string_view minutes = source.text(lexemes[at + 1]);
  const Lexeme whole{GliderLexer::NUMBER, lexemes[at].begin, lexemes[at + 1].end};
  const std::string_view gap =
      source.text().substr(lexemes[at].end, lexemes[at + 1].begin - lexemes[at].end);
  const bool good = areDigits(degrees) && degrees.size() <= kMostDegrees &&
                    minutes.find_first_of("eE") == std::string_view::npos &&
                    std::strtod(std::string(minutes).c_str(), nullptr) < kMinutes &&
                    gap.find_first_not_of(" \t") == std::string_view::npos;
  return good ? std::optional(whole) : std::nullopt;
}

}  // namespace glider::frontend
