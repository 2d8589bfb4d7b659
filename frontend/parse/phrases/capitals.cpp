// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"
#include "support/diagnostics/ids/syntax.h"

#include <algorithm>

namespace glider::frontend::phrases {
namespace {

bool isValue(uint32_t keyword) {
  return oneOf(keyword, {GliderLexer::TRUE, GliderLexer::FALSE});
}

bool isJoining(uint32_t keyword) {
  return oneOf(keyword, {GliderLexer::AND_WORD, GliderLexer::OR_WORD, GliderLexer::NOT_WORD});
}

/// Whether a keyword may stand here, and a name may not.
bool mayBeKeyword(const Phrase& phrase) {
  const uint32_t before = phrase.before();
  return before == 0 || endsValue(before) || phrase.mayBeginCase() ||
         oneOf(before, {GliderLexer::END, GliderLexer::BEGIN, GliderLexer::DO, GliderLexer::THEN,
                        GliderLexer::ELSE, GliderLexer::ENTRY, GliderLexer::REQUIRE,
                        GliderLexer::EXTERN, GliderLexer::ALWAYS});
}

}  // namespace

size_t capitals(Phrase& phrase) {
  if (phrase.type() != GliderLexer::NAME || !phrase.open().empty()) {
    return 0;
  }
  const auto isCapital = [](char c) { return 'A' <= c && c <= 'Z'; };
  if (std::ranges::none_of(phrase.text(), isCapital) && phrase.text() != "place") {
    return 0;
  }
  const Lexeme word = phrase.token();
  const std::string small = phrase.lower();
  // `place` may also be a name.
  const bool place = small == "place" && phrase.startsLine() && isAnyName(phrase.type(1)) &&
                     phrase.type(2) == GliderLexer::ASSIGN;
  const uint32_t meant = place ? uint32_t{GliderLexer::PLACE} : keywordType(small);
  const uint32_t keyword = small == phrase.text() ? 0 : meant;
  if (keyword == 0 || isJoining(keyword) || wantsName(phrase.before()) ||
      !(isValue(keyword) || mayBeKeyword(phrase)) || phrase.isDeclared(phrase.text())) {
    return 0;
  }
  phrase.reporter()
      .at(word, support::diagnostics::misspelledKeyword, phrase.text(), small)
      .fix(phrase.source().range(word), small);
  phrase.put({keyword, word.begin, word.end});
  return 1;
}

}  // namespace glider::frontend::phrases
