// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/lexeme.h"

#include <string>
#include <vector>

/// Words that pilots write although nothing is said by them: `end look`, `case depth > 5 m then`.
namespace glider::frontend {

/// What stands around a token.
struct TokenContext {
  const Source& source;
  const std::vector<Lexeme>& before;  ///< as repaired so far
  const Lexeme& next;
  bool in_condition = false;  ///< of a case, outside parentheses
  bool keyword = false;       ///< the token is one, or the end of the file
};

/// Where `t` is not written, as in "after `end`", if nothing is said by it; otherwise empty.
std::string superfluousWhere(const TokenContext& around, const Lexeme& t);

}  // namespace glider::frontend
