// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/lexeme.h"
#include "frontend/parse/reporter.h"

#include <vector>

namespace glider::frontend {

/// What is left to parse.
struct Repaired {
  std::vector<Lexeme> lexemes;
  bool parseable =
      true;  ///< false if reading on would only mislead: nested too deep, too many mistakes
};

/// Reports the usual mistakes (`;`, `=` for `==`, a missing comma, `begin` or `end`…) and mends the
/// tokens as the pilot meant them, so that one of these never hides what comes after it. Afterwards
/// every block and parenthesis is closed.
Repaired repair(const std::vector<Lexeme>& lexemes, SyntaxReporter& reporter);

}  // namespace glider::frontend
