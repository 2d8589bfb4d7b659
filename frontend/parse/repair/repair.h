// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/lexeme.h"
#include "frontend/parse/reporter.h"

#include <vector>

namespace glider::frontend {

/// The tokens to be parsed.
struct Repaired {
  std::vector<Lexeme> lexemes;
  bool parseable =
      true;  ///< false if reading further would only mislead: nested too deep, too many errors
  bool named = true;  ///< false if a name is not what it was meant to be: uses would not be found
};

/// Reports common errors (`;`, `=` for `==`, a missing comma, `begin` or `end`…) and repairs the
/// tokens as the pilot meant them, so that such an error never hides what comes after it.
/// Afterwards every block and parenthesis is closed.
Repaired repair(const std::vector<Lexeme>& lexemes, SyntaxReporter& reporter);

}  // namespace glider::frontend
