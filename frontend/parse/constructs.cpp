// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/constructs.h"

#include "frontend/parse/lexeme.h"
#include "frontend/parse/token_kinds.h"

namespace glider::frontend {
namespace {

/// Whether what it opens, closes or separates reaches beyond its own line.
bool isStructure(uint32_t type) {
  return startsItem(type) || startsMember(type) ||
         oneOf(type, {GliderLexer::BEGIN, GliderLexer::END, GliderLexer::DO, GliderLexer::IF,
                      GliderLexer::THEN, GliderLexer::ELSE, GliderLexer::CASE});
}

}  // namespace

support::Constructs constructsOf(std::string_view text) {
  support::Constructs found;
  found.structure.assign(hardKeywords().begin(), hardKeywords().end());
  uint32_t before = 0;
  for (const Lexeme& t : lex(text, 0)) {
    const bool promise = before == GliderLexer::REQUIRE;
    const bool item = startsItem(t.type) && !promise;
    if (item) {
      found.items.push_back(t.begin);
    }
    const bool member =
        startsMember(t.type) || t.type == GliderLexer::CASE || t.type == GliderLexer::VAR;
    // A header ends with its `begin`.
    if (item || (member && !promise) || before == GliderLexer::BEGIN) {
      found.parts.push_back(t.begin);
    }
    if (isStructure(t.type)) {
      found.words.push_back({t.begin, t.end});
    }
    before = t.type;
  }
  return found;
}

}  // namespace glider::frontend
