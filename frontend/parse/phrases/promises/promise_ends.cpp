// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What comes after the first words of a promise.

#include "frontend/parse/phrases/promises/parts.h"
#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>

namespace glider::frontend::phrases {
namespace {

/// What the word at `k` counts: 2 of `twice`; 0 of any other.
size_t countInWords(const Phrase& phrase, size_t k) {
  constexpr std::string_view kWords[] = {"once", "twice", "thrice"};
  const auto* word =
      std::ranges::find_if(kWords, [&](std::string_view one) { return phrase.says(k, one); });
  return word == std::end(kWords) ? 0 : static_cast<size_t>(word - kWords) + 1;
}

std::string_view turnedRound(uint32_t comparison) {
  switch (comparison) {
    case GliderLexer::LT:
      return ">=";
    case GliderLexer::LE:
      return ">";
    case GliderLexer::GT:
      return "<=";
    case GliderLexer::GE:
      return "<";
    default:
      return "";
  }
}

}  // namespace

size_t timesLeftOut(Phrase& phrase) {
  const bool limit = oneOf(phrase.type(), {GliderLexer::MOST, GliderLexer::LEAST}) &&
                     phrase.before() == GliderLexer::AT;
  if (phrase.keyword() != GliderLexer::REQUIRE || !limit || !isAnyName(phrase.before(1))) {
    return 0;
  }
  const Lexeme word = phrase.token();
  const Lexeme count = phrase.token(1);
  const size_t said = countInWords(phrase, 1);
  const bool number = count.type == GliderLexer::NUMBER &&
                      phrase.type(2) != GliderLexer::TIMES_WORD && !isOperator(phrase.type(2)) &&
                      (phrase.startsLine(2) || oneOf(phrase.type(2), {GliderLexer::WITHIN, kEof}));
  if (said == 0 && !number) {
    return 0;
  }
  const std::string better =
      (said != 0 ? std::to_string(said) : std::string(phrase.text(1))) + " times";
  phrase.reporter()
      .at(count, support::diagnostics::unexpectedToken, "how many `times`",
          describe(phrase.source(), count))
      .hint(fmt::format("write `at {} {}`", phrase.text(), better))
      .fix(phrase.source().range(count), better);
  phrase.put(word);
  phrase.put({GliderLexer::NUMBER, count.begin, count.end});
  phrase.put({GliderLexer::TIMES_WORD, count.end, count.end});
  if (said != 0) {
    phrase.notAsMeant();
  }
  return 2;
}

std::string neverInstead(const Phrase& phrase, size_t first, size_t count) {
  for (size_t k = 1; k < count; ++k) {
    const std::string_view sign = turnedRound(phrase.type(first + k));
    if (!sign.empty()) {
      return fmt::format("never {} {} {}", phrase.wholeText(first, k), sign,
                         phrase.wholeText(first + k + 1, count - k - 1));
    }
  }
  return fmt::format("never !({})", phrase.wholeText(first, count));
}

size_t alwaysAfterScope(Phrase& phrase) {
  const size_t count = tokensOfValue(phrase, 1, true);
  if (phrase.before() != GliderLexer::COLON || phrase.keyword() != GliderLexer::REQUIRE ||
      count == 0) {
    return 0;
  }
  const Lexeme word = phrase.token();
  const Lexeme colon = *phrase.lexemeBefore();  // without text if scopeWithoutColon has put it
  phrase.reporter()
      .at(word, support::diagnostics::unexpectedToken,
          "what happens there, such as `never` and a condition", "`always`")
      .hint(fmt::format("write `{}{}`", colon.begin == colon.end ? ": " : "",
                        neverInstead(phrase, 1, count)));
  phrase.put({GliderLexer::NEVER, word.begin, word.end});
  phrase.notAsMeant();
  return 1;
}

size_t orExitOfSurfaces(Phrase& phrase) {
  constexpr size_t kLongestTime = 8;  // tokens since `surfaces every`
  bool surfaces = false;
  for (size_t k = 0; k < kLongestTime; ++k) {
    surfaces = surfaces || (phrase.before(k) == GliderLexer::EVERY &&
                            phrase.before(k + 1) == GliderLexer::SURFACES);
  }
  if (phrase.keyword() != GliderLexer::REQUIRE || !surfaces ||
      phrase.type(1) != GliderLexer::EXIT) {
    return 0;
  }
  const Lexeme both = phrase.whole(0, 2);
  phrase.reporter()
      .at(both, support::diagnostics::superfluousWord, "or exit", "after `surfaces every`")
      .fix({phrase.source().file, phrase.lexemeBefore()->end, both.end}, "");
  return 2;
}

}  // namespace glider::frontend::phrases
