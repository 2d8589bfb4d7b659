// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/lexeme.h"

#include <optional>
#include <vector>

namespace glider::frontend {

/// `39 10.5 N`: half of a position in degrees and minutes. The first two tokens as one, a number
/// with a space in it; empty if token `at` does not begin one. Only the letter distinguishes it
/// from two numbers, so the lexer cannot.
std::optional<Lexeme> degreesAndMinutes(const std::vector<Lexeme>& lexemes, size_t at,
                                        const Source& source);

}  // namespace glider::frontend
