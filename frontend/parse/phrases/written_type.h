// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/phrases/phrase.h"

#include <string_view>

/// The types of values that are written out, which a declaration may lack.
namespace glider::frontend {

/// The type of what has this unit: "length", and "number" without one; empty: not known.
std::string_view typeOfUnit(std::string_view unit);

/// The dimension of the value that is written out from token `k` on, as a type: "length"; empty:
/// not known.
std::string_view typeOf(const Phrase& phrase, size_t k);

/// Whether `word` is a type of variables.
bool isTypeName(std::string_view word);

/// The type that `word` may be a misspelling of; empty: there is none.
std::string_view nearTypeName(std::string_view word);

}  // namespace glider::frontend
