// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/lexeme.h"
#include "frontend/parse/outline.h"

#include <cstddef>
#include <vector>

namespace glider::frontend {

/// Reads `(top: length, …): TYPE` after a declared name, as far as it exists, from token `at` on;
/// returns the first token after it.
size_t readHeader(const Source& source, const std::vector<Lexeme>& lexemes, size_t at,
                  OutlineDeclaration& declaration);

}  // namespace glider::frontend
