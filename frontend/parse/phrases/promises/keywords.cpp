// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Promises that begin with another word than `require`.

#include "frontend/parse/phrases/comparing.h"
#include "frontend/parse/phrases/promises/parts.h"
#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace glider::frontend::phrases {
namespace {

bool isPromiseWord(const Phrase& phrase) {
  constexpr std::array<std::string_view, 9> kWords = {"requires",  "required", "ensure",
                                                      "ensures",   "promise",  "promises",
                                                      "guarantee", "assert",   "demand"};
  return std::ranges::any_of(kWords, [&](auto word) { return phrase.says(0, word); });
}

/// Whether a declaration may begin at the current token.
bool mayDeclare(const Phrase& phrase) {
  return phrase.startsLine() && phrase.open().empty() && !phrase.mayBeginCase() &&
         (phrase.before() == GliderLexer::END || endsValue(phrase.before())) &&
         !oneOf(phrase.keyword(),
                {GliderLexer::DO, GliderLexer::THEN, GliderLexer::ELSE, GliderLexer::SET,
                 GliderLexer::LOG, GliderLexer::SENSORS, GliderLexer::BEGIN, GliderLexer::EVENTS,
                 GliderLexer::CASE, GliderLexer::FLIGHTPROFILE, GliderLexer::FLIGHTROUTE});
}

/// `ensure always depth <= 60 m`, `promise depth <= 60 m`.
size_t wordForRequire(Phrase& phrase) {
  if (phrase.type() != GliderLexer::NAME || !isPromiseWord(phrase) || phrase.startsLine(1) ||
      phrase.type(1) == GliderLexer::ASSIGN || phrase.isDeclared(phrase.text())) {
    return 0;
  }
  const Lexeme word = phrase.token();
  const size_t condition = tokensOfWholeCondition(phrase, 1);
  const bool bare = condition >= 3 && isName(phrase.type(1));
  auto report =
      phrase.reporter().at(word, support::diagnostics::misspelledKeyword, phrase.text(), "require");
  report
      .hint(bare ? fmt::format("write `require always {}`", phrase.wholeText(1, condition))
                 : "write `require`")
      .fix(phrase.source().range(word), bare ? "require always" : "require");
  phrase.put({GliderLexer::REQUIRE, word.begin, word.end});
  if (bare) {
    phrase.insert(GliderLexer::ALWAYS);
  }
  return 1;
}

/// `depth must be <= 60 m`, `depth must stay below 60 m`.
size_t mustBe(Phrase& phrase) {
  constexpr std::array<std::string_view, 4> kWords = {"must be", "should be", "must stay",
                                                      "shall be"};
  size_t words = 0;
  for (const std::string_view one : kWords) {
    words = words == 0 ? tokensOfWords(phrase, 1, one) : words;
  }
  const ComparingPhrase compares = words == 0 ? ComparingPhrase{} : comparingAt(phrase, 1);
  const bool sign =
      phrase.type(1 + words) >= GliderLexer::EQ && phrase.type(1 + words) <= GliderLexer::GT;
  const size_t first = compares.tokens > 0 ? 1 + compares.tokens : 2 + words;
  const size_t number =
      words > 0 && (sign || compares.tokens > 0) ? tokensOfQuantity(phrase, first) : 0;
  if (!isName(phrase.type()) || number == 0 || !phrase.startsLine(first + number)) {
    return 0;
  }
  const Lexeme whole = phrase.whole(0, first + number);
  const std::string better =
      fmt::format("require always {} {} {}", phrase.text(),
                  compares.tokens > 0 ? compares.sign : phrase.text(1 + words),
                  phrase.wholeText(first, number));
  expected(phrase, phrase.token(), "`require`")
      .hint(fmt::format("write `{}`", better))
      .fix(phrase.source().range(whole), better);
  phrase.put({GliderLexer::REQUIRE, whole.begin, whole.begin});
  phrase.put({GliderLexer::ALWAYS, whole.begin, whole.begin});
  phrase.put({GliderLexer::TRUE, whole.begin, whole.end});
  phrase.notAsMeant();
  return first + number;
}

}  // namespace

size_t promiseWithoutRequire(Phrase& phrase) {
  return mayDeclare(phrase) ? firstOf(phrase, {wordForRequire, mustBe}) : 0;
}

}  // namespace glider::frontend::phrases
