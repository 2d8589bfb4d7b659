// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/lexeme.h"
#include "frontend/parse/reporter.h"

#include <vector>

namespace glider::frontend {

/// The tokens with what was meant by phrases of other languages and of prose.
struct Rephrased {
  std::vector<Lexeme> lexemes;
  bool as_meant = true;  ///< false if names and types of the result are not those of the text
};

/// The first pass of repair: errors that are recognised by several tokens. Each is reported once.
Rephrased repairPhrases(const std::vector<Lexeme>& lexemes, SyntaxReporter& reporter);

}  // namespace glider::frontend
