// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

namespace glider::frontend::phrases {

size_t ifInCondition(Phrase& phrase) {
  const bool joined = oneOf(phrase.before(), {GliderLexer::AND, GliderLexer::OR,
                                              GliderLexer::AND_WORD, GliderLexer::OR_WORD});
  if (!joined || phrase.keyword() != GliderLexer::CASE) {
    return 0;
  }
  const Lexeme word = phrase.token();
  phrase.reporter()
      .at(word, support::diagnostics::superfluousWord, phrase.text(),
          fmt::format("after `{}`", phrase.source().text(*phrase.lexemeBefore())))
      .fix({phrase.source().file, word.begin, phrase.token(1).begin}, "");
  return 1;
}

size_t equalToTruth(Phrase& phrase) {
  const bool word = phrase.says(0, "equals") || phrase.says(0, "is");
  const size_t negation = phrase.says(0, "is") && phrase.says(1, "not") ? 1 : 0;
  const bool sign = phrase.type() == GliderLexer::WRONG_COMPARISON &&
                    (phrase.text() == "<>" || phrase.text() == "===");
  const bool compares = oneOf(phrase.type(), {GliderLexer::EQ, GliderLexer::NE});
  const size_t truth_at = 1 + negation;
  const bool truth = oneOf(phrase.type(truth_at), {GliderLexer::TRUE, GliderLexer::FALSE});
  const bool begins =
      oneOf(phrase.before(1), {GliderLexer::CASE, GliderLexer::IF, GliderLexer::AND,
                               GliderLexer::OR, GliderLexer::AND_WORD, GliderLexer::OR_WORD});
  const bool enclosed = phrase.before(1) == GliderLexer::LPAREN && !phrase.open().empty() &&
                        !phrase.open().back().arguments;
  const bool equal = phrase.type() == GliderLexer::ASSIGN || word || sign || compares;
  if (!equal || !truth || !(begins || (enclosed && !compares)) || !isName(phrase.before())) {
    return 0;
  }
  const Lexeme name = *phrase.lexemeBefore();
  const std::string_view condition = phrase.source().text(name);
  const bool negated = negation == 1 || phrase.text() == "<>" || phrase.type() == GliderLexer::NE;
  const bool is_true = (phrase.type(truth_at) == GliderLexer::TRUE) != negated;
  const Lexeme found = phrase.whole(0, truth_at);
  const std::string better = fmt::format("{}{}", is_true ? "" : "!", condition);
  const support::DiagnosticId id = sign   ? support::diagnostics::wrongComparison
                                   : word ? support::diagnostics::wordOperator
                                          : support::diagnostics::assignForEqual;
  auto report =
      compares ? phrase.reporter().at(found, support::diagnostics::superfluousWord, phrase.text(),
                                      fmt::format("before `{}`", phrase.text(truth_at)))
               : phrase.reporter().at(found, id, phrase.source().text(found), better);
  report.hint(fmt::format("a condition stands alone: write `{}`", better))
      .fix({phrase.source().file, name.begin, phrase.token(truth_at).end}, better);
  return truth_at + 1;
}

size_t heldWithoutParentheses(Phrase& phrase) {
  constexpr size_t kFarthest = 60;
  if (!phrase.says(0, "held") || phrase.type() != GliderLexer::NAME ||
      phrase.keyword() != GliderLexer::CASE || !startsValue(phrase.type(1)) ||
      phrase.isDeclared(phrase.text())) {
    return 0;
  }
  size_t word = 1;
  while (word < kFarthest && !oneOf(phrase.type(word), {GliderLexer::FOR, GliderLexer::COMMA})) {
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

namespace {

/// How many of the tokens that were read are `NAME > NUMBER UNIT`; 0: they are something else.
size_t tokensOfComparisonBefore(const Phrase& phrase) {
  const size_t unit = phrase.before() == GliderLexer::NUMBER ? 0 : 1;
  const bool compares = phrase.before(unit) == GliderLexer::NUMBER &&
                        oneOf(phrase.before(unit + 1), {GliderLexer::LT, GliderLexer::GT,
                                                        GliderLexer::LE, GliderLexer::GE}) &&
                        isName(phrase.before(unit + 2));
  const bool begins = oneOf(phrase.before(unit + 3),
                            {GliderLexer::CASE, GliderLexer::AND, GliderLexer::OR,
                             GliderLexer::AND_WORD, GliderLexer::OR_WORD, GliderLexer::LPAREN});
  return compares && begins ? unit + 3 : 0;
}

}  // namespace

size_t forATime(Phrase& phrase) {
  constexpr std::string_view kLeast[] = {"at least", "more than", "longer than", "over"};
  size_t words = 0;  // `for at least 1 min`
  for (const std::string_view least : kLeast) {
    words = words == 0 ? tokensOfWords(phrase, 1, least) : words;
  }
  const size_t time = tokensOfQuantity(phrase, 1 + words);
  if (time == 0 || phrase.keyword() != GliderLexer::CASE || !endsValue(phrase.before())) {
    return 0;
  }
  const Source& source = phrase.source();
  const Lexeme word = phrase.token();
  const Lexeme last = *phrase.lexemeBefore();
  const bool inside = !phrase.open().empty() && phrase.open().back().arguments;
  if (inside) {
    phrase.reporter()
        .at(word, support::diagnostics::unexpectedToken, "`,`", describe(source, word))
        .hint("write `,` for it")
        .fix({source.file, last.end, phrase.token(words).end}, ",");
    phrase.put({GliderLexer::COMMA, word.begin, word.end});
    return 1 + words;
  }
  const std::string_view duration = phrase.wholeText(1 + words, time);
  const size_t count = tokensOfComparisonBefore(phrase);
  auto report = phrase.reporter().at(word, support::diagnostics::unexpectedToken, "an operator",
                                     describe(source, word));
  if (count == 0) {
    report.hint(fmt::format("write `held(…, {})` around the condition", duration));
  } else {
    const uint32_t begin = phrase.lexemeBefore(count - 1)->begin;
    const std::string better =
        fmt::format("held({}, {})", source.text({0, begin, last.end}), duration);
    report.hint(fmt::format("write `{}`", better))
        .fix({source.file, begin, phrase.token(words + time).end}, better);
  }
  return 1 + words + time;
}

size_t valueForCondition(Phrase& phrase) {
  const bool joins = oneOf(phrase.type(), {GliderLexer::OR, GliderLexer::OR_WORD, GliderLexer::AND,
                                           GliderLexer::AND_WORD});
  const size_t compared = joins && phrase.readsValues() ? tokensOfComparisonBefore(phrase) : 0;
  const size_t value = compared == 0 ? 0 : tokensOfQuantity(phrase, 1);
  const uint32_t next = phrase.type(1 + value);
  const bool ends = isTransition(next) || oneOf(next, {GliderLexer::DO, GliderLexer::THEN,
                                                       GliderLexer::RPAREN, GliderLexer::COMMA});
  if (value < 2 || !ends) {
    return 0;
  }
  const Lexeme name = *phrase.lexemeBefore(compared - 1);
  const Lexeme sign = *phrase.lexemeBefore(compared - 2);
  const Lexeme word = phrase.token();
  const bool either = oneOf(word.type, {GliderLexer::OR, GliderLexer::OR_WORD});
  const Source& source = phrase.source();
  phrase.reporter()
      .at(phrase.token(1), support::diagnostics::unexpectedToken, "a condition",
          describe(source, phrase.token(1)))
      .hint(fmt::format("write the name again: `{} {} {} {} {}`",
                        source.text({0, name.begin, phrase.lexemeBefore()->end}),
                        either ? "||" : "&&", source.text(name), source.text(sign),
                        phrase.wholeText(1, value)));
  phrase.put({either ? GliderLexer::OR : GliderLexer::AND, word.begin, word.end});
  phrase.put(name);
  phrase.put(sign);
  return 1;
}

}  // namespace glider::frontend::phrases
