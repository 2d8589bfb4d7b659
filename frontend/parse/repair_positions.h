// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/lexeme.h"

#include <optional>
#include <string>
#include <vector>

namespace glider::frontend {

/// `39 10.5 N`: half of a position in degrees and minutes. The first two tokens as one, a number
/// with a space in it; empty if token `at` does not begin one. Only the letter distinguishes it
/// from two numbers, so the lexer cannot.
std::optional<Lexeme> degreesAndMinutes(const std::vector<Lexeme>& lexemes, size_t at,
                                        const Source& source);

/// Half of a position as charts and other tools write it: `39°10.5'N`, `39 10 30 N`, `N39.175`,
/// `39.175°N`.
struct ForeignPosition {
  Lexeme whole;
  size_t count = 0;     ///< tokens that it takes
  Lexeme number;        ///< used instead: its degrees
  Lexeme letter;        ///< and its N, S, E or W
  std::string better;   ///< as the language writes it: "39.175 N"
  bool certain = true;  ///< it can only be read in one way
};

/// The half of a position that begins with token `at` and is not written as in the language, if
/// there is one.
std::optional<ForeignPosition> foreignPosition(const std::vector<Lexeme>& lexemes, size_t at,
                                               const Source& source);

}  // namespace glider::frontend
