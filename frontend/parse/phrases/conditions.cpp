// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

namespace glider::frontend::phrases {

size_t equalToTruth(Phrase& phrase) {
  const bool truth = oneOf(phrase.type(1), {GliderLexer::TRUE, GliderLexer::FALSE});
  const bool begins =
      oneOf(phrase.before(1), {GliderLexer::CASE, GliderLexer::IF, GliderLexer::AND,
                               GliderLexer::OR, GliderLexer::AND_WORD, GliderLexer::OR_WORD});
  if (!truth || !begins || !isName(phrase.before())) {
    return 0;
  }
  const Lexeme name = *phrase.lexemeBefore();
  const std::string_view word = phrase.source().text(name);
  const bool is_true = phrase.type(1) == GliderLexer::TRUE;
  const Lexeme sign = phrase.token();
  const std::string better = fmt::format("{}{}", is_true ? "" : "!", word);
  auto report = phrase.reporter().at(sign, support::diagnostics::assignForEqual);
  report.hint(fmt::format("a condition stands alone: write `{}`", better))
      .fix({phrase.source().file, name.begin, phrase.token(1).end}, better);
  return 2;
}

size_t heldWithoutParentheses(Phrase& phrase) {
  constexpr size_t kFarthest = 60;
  if (!phrase.says(0, "held") || phrase.type() != GliderLexer::NAME ||
      phrase.keyword() != GliderLexer::CASE || !startsValue(phrase.type(1)) ||
      phrase.isDeclared(phrase.text())) {
    return 0;
  }
  size_t word = 1;
  while (word < kFarthest && phrase.type(word) != GliderLexer::FOR) {
    ++word;
  }
  const size_t time = tokensOfNumber(phrase, word + 1);
  if (time == 0 || !readsAsValue(phrase, 1, word - 1)) {
    return 0;
  }
  const Lexeme name = phrase.token();
  const size_t end = word + 1 + time;
  const std::string better =
      fmt::format("held({}, {})", phrase.wholeText(1, word - 1), phrase.wholeText(word + 1, time));
  phrase.reporter()
      .at(phrase.whole(0, end), support::diagnostics::argumentsWithoutParentheses, phrase.text(),
          better)
      .fix(phrase.source().range(phrase.whole(0, end)), better);
  phrase.put(name);
  phrase.insert(GliderLexer::LPAREN);
  for (size_t k = 1; k < end; ++k) {
    const Lexeme& t = phrase.token(k);
    phrase.put(k == word ? Lexeme{GliderLexer::COMMA, t.begin, t.end} : t);
  }
  phrase.insert(GliderLexer::RPAREN);
  return end;
}

}  // namespace glider::frontend::phrases
