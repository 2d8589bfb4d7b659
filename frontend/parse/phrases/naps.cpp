// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/choices/clauses.h"
#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"
#include "frontend/spelling.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <string>

// The line `nap at most 4 min`, as pilots write it.

namespace glider::frontend::phrases {
namespace {

/// What pilots call a nap of the SBC.
size_t napWord(const Phrase& phrase) {
  return tokensOfOne(phrase, 0,
                     {"nap", "naps", "napping", "sleep", "sleeps", "sleeping", "doze", "snooze"});
}

/// `at most`, and what stands for it, from token `k` on.
size_t limitWords(const Phrase& phrase, size_t k) {
  return tokensOfOne(phrase, k,
                     {"for at most", "for up to", "for no more than", "no longer than",
                      "no more than", "at most", "up to", "within", "max", "maximum", "limit"});
}

/// `for 4 min`: what says how long, and not that it is the longest.
size_t otherWords(const Phrase& phrase, size_t k) {
  return tokensOfOne(phrase, k, {"time", "for", "at", "of"});
}

/// The right line, whose `at most` compares nothing: `nap at most longest`.
size_t rightLine(Phrase& phrase) {
  const size_t limit = tokensOfWords(phrase, 1, "at most");
  const bool begins =
      mayBeginItem(phrase) ||
      oneOf(phrase.before(), {GliderLexer::NAME, GliderLexer::NUMBER, GliderLexer::UNIT,
                              GliderLexer::MIN, GliderLexer::STRING, GliderLexer::RPAREN});
  if (phrase.type() != GliderLexer::NAP || limit == 0 || !begins) {
    return 0;
  }
  for (size_t k = 0; k <= limit; ++k) {
    phrase.put(phrase.token(k));
  }
  return 1 + limit;
}

/// The time from token `k` on, as it is right: `4 minutes` is `4 min`.
std::string timeAt(const Phrase& phrase, size_t k) {
  const std::string_view unit =
      phrase.startsLine(k + 1) ? std::string_view() : unitForWord(phrase.text(k + 1));
  return unit.empty() ? std::string(phrase.wholeText(k, tokensOfQuantity(phrase, k)))
                      : fmt::format("{} {}", phrase.text(k), unit);
}

bool isSign(uint32_t type) {
  return oneOf(type, {GliderLexer::ASSIGN, GliderLexer::COLON, GliderLexer::LE, GliderLexer::LT});
}

/// Says what is wrong before token `number`, and reads the line as it is meant: `word` tokens name
/// the nap, the next `limit` say that the time is the longest.
void report(Phrase& phrase, size_t word, size_t limit, size_t number) {
  const bool named = phrase.type() == GliderLexer::NAP;
  const bool only_sign = named && tokensOfWords(phrase, word, "at most") > 0;
  const Lexeme found = phrase.token(!named ? 0 : only_sign ? word + limit : word);
  const char* expected = !named ? "`nap`" : only_sign ? "a time" : "`at most`";
  auto report = phrase.reporter().at(found, support::diagnostics::unexpectedToken, expected,
                                     describe(phrase.source(), found));
  report.hint(fmt::format("write `nap at most {}`", timeAt(phrase, number)));
  // `sleep 4 min` may also be meant as a wait.
  if (phrase.lower().starts_with("nap") || limit > 0) {
    report.fix(phrase.source().range(phrase.whole(0, number)), "nap at most");
  }
  phrase.put({GliderLexer::NAP, phrase.token().begin, phrase.token().end});
  phrase.insert(GliderLexer::AT);
  phrase.insert(GliderLexer::MOST);
}

}  // namespace

size_t nap(Phrase& phrase) {
  const size_t word = napWord(phrase);
  const bool at_most = word > 0 && tokensOfWords(phrase, word, "at most") > 0;
  if (const size_t right = at_most && !isSign(phrase.type(word + 2)) ? rightLine(phrase) : 0) {
    return right;
  }
  if (word == 0 || !mayBeginItem(phrase)) {
    return 0;
  }
  const size_t limit = limitWords(phrase, word);
  size_t number = word + (limit > 0 ? limit : otherWords(phrase, word));
  number += isSign(phrase.type(number)) ? 1U : 0U;
  if (phrase.type(number) != GliderLexer::NUMBER || phrase.startsLine(number)) {
    return 0;
  }
  report(phrase, word, limit, number);
  return number;
}

}  // namespace glider::frontend::phrases
