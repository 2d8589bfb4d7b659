// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/lexeme.h"

#include <vector>

namespace glider::frontend {

/// The tokens of a file in which something is declared with the name of a unit, `var s: number =
/// 0`: the uses of that name are names too, so that only the declaration is refused, by analysis.
std::vector<Lexeme> nameDeclaredUnits(std::vector<Lexeme> lexemes, const Source& source);

}  // namespace glider::frontend
