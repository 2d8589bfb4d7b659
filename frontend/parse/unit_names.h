// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/lexeme.h"

#include <vector>

namespace glider::frontend {

/// The tokens of a file in which something has the name of a unit, as a state may. `var s: number =
/// 0` is refused: the uses of that name are names too, so that only the declaration is reported.
std::vector<Lexeme> nameDeclaredUnits(std::vector<Lexeme> lexemes, const Source& source);

}  // namespace glider::frontend
