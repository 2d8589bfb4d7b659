// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/lexeme.h"

#include <optional>
#include <string>
#include <vector>

namespace glider::frontend {

/// An `if` or `for` without its `end`, and where that belongs.
struct UnendedBlock {
  Lexeme opener;
  std::string what;  ///< "this `if`"
  Lexeme before;     ///< the first token after the block
  uint32_t place = 0;
  std::string text;  ///< the `end`, as its own line
};

/// What the indentation says of an `end` that closes an `if` or `for` inside other actions.
struct EndOfBlock {
  bool sure = false;                    ///< it is certainly the `end` of that block
  std::optional<UnendedBlock> unended;  ///< it is not: the block has none
};

/// `opener` and `end` are numbers of tokens in `in`, `outer` is the `do` of all the actions.
EndOfBlock endByIndentation(const Source& source, const std::vector<Lexeme>& in, size_t outer,
                            size_t opener, size_t end);

}  // namespace glider::frontend
