// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/phrases/phrase.h"

/// What the repairs of promises share.
namespace glider::frontend::phrases {

/// "expected `always`, found …".
support::DiagnosticBuilder expected(Phrase& phrase, const Lexeme& found, std::string_view what);

/// Whether a token compares, or is the `=` that is meant to.
bool isComparisonSign(uint32_t type);

/// The tokens of the condition from token `first` on, which ends its line; 0: there is none. After
/// it, on a later line, a declaration may begin with a word that is also a name.
size_t tokensOfWholeCondition(const Phrase& phrase, size_t first);

/// `max depth 60 m`, `never deeper than 60 m`, `always within 5 km of home`, `depth no more than
/// 60 m`: what was read is the promise that a value stays below or above a limit.
size_t limitInWords(Phrase& phrase);

/// `never depth > 60 m` for the condition `depth <= 60 m` of `count` tokens from token `first` on.
std::string neverInstead(const Phrase& phrase, size_t first, size_t count);

/// `in look never depth > 60 m`: the colon after the scope is missing.
size_t scopeWithoutColon(Phrase& phrase);

/// `never depth > 60 m in look`: the scope of a promise comes before it.
size_t scopeAtEnd(Phrase& phrase);

/// `never more than 2 look`, `never look more than 2 times`.
size_t neverMoreTimes(Phrase& phrase);

/// `never enter shoal`, `never leave box`: of an area it is a condition, which always holds.
size_t neverEnters(Phrase& phrase);

/// `whenever low then exit within 2 h`, `visit exit within 9 h`.
size_t exitAsPlace(Phrase& phrase);

/// `eventually look within 2 h`.
size_t eventually(Phrase& phrase);

}  // namespace glider::frontend::phrases
