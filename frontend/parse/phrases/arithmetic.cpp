// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Values as they are said, or as a spreadsheet or C has them.

#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"
#include "frontend/spelling.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <ranges>

namespace glider::frontend::phrases {
namespace {

constexpr std::string_view kNoConditionalValue =
    "no value has a condition: write two cases, or `set` a variable in `if … then … else … end` "
    "and compare with it";

struct Arithmetic {
  std::string_view word;
  std::string_view then;  ///< a second word
  std::string_view sign;
  uint32_t type;
};
constexpr Arithmetic kArithmetic[] = {{"plus", "", "+", GliderLexer::PLUS},
                                      {"minus", "", "-", GliderLexer::MINUS},
                                      {"divided", "by", "/", GliderLexer::DIVIDE},
                                      {"multiplied", "by", "*", GliderLexer::TIMES}};

/// `max minus 10 m`.
size_t wordForSign(Phrase& phrase) {
  const auto* row = std::ranges::find_if(kArithmetic, [&](const Arithmetic& one) {
    return phrase.says(0, one.word) && (one.then.empty() || phrase.says(1, one.then));
  });
  const size_t tokens = row == std::end(kArithmetic) || row->then.empty() ? 1 : 2;
  if (row == std::end(kArithmetic) || !endsValue(phrase.before()) || phrase.startsLine() ||
      !startsAnyValue(phrase.type(tokens)) || phrase.isDeclared(phrase.text())) {
    return 0;
  }
  const Lexeme words = phrase.whole(0, tokens, row->type);
  phrase.reporter()
      .at(words, support::diagnostics::wordOperator, phrase.source().text(words), row->sign)
      .fix(phrase.source().range(words), std::string(row->sign));
  phrase.put(words);
  return tokens;
}

/// `temp at 20 m`.
size_t readingAtDepth(Phrase& phrase) {
  const size_t depth = tokensOfNumber(phrase, 1);
  if (phrase.type() != GliderLexer::AT || !isAnyName(phrase.before()) || depth < 2 ||
      phrase.text(2) != "m" ||
      !oneOf(phrase.keyword(), {GliderLexer::CASE, GliderLexer::SET, GliderLexer::IF})) {
    return 0;
  }
  const std::string_view name = phrase.source().text(*phrase.lexemeBefore());
  phrase.reporter()
      .at(phrase.token(), support::diagnostics::unexpectedToken, "an operator",
          describe(phrase.source(), phrase.token()))
      .hint(fmt::format("`{0}` is the reading of now: keep the one of a depth in a variable, as in "
                        "`case became(depth > {1}) do set … = {0} end stay`",
                        name, phrase.wholeText(1, depth)));
  return 1 + depth;
}

/// `distance to home`.
size_t distanceTo(Phrase& phrase) {
  const bool function = phrase.says(0, "distance") || phrase.says(0, "bearing");
  const bool to = oneOf(phrase.type(1), {GliderLexer::TO, GliderLexer::FROM});
  if (!function || !to || !isName(phrase.type(2)) || phrase.startsLine(2) ||
      endsValue(phrase.before()) || phrase.isDeclared(phrase.text())) {
    return 0;
  }
  const Lexeme name = phrase.token();
  const Lexeme place = phrase.token(2);
  const Lexeme whole = phrase.whole(0, 3);
  const std::string better = fmt::format("{}({})", phrase.text(), phrase.text(2));
  phrase.reporter()
      .at(whole, support::diagnostics::argumentsWithoutParentheses, phrase.text(), better)
      .fix(phrase.source().range(whole), better);
  phrase.put(name);
  phrase.put({GliderLexer::LPAREN, name.end, name.end});
  phrase.put(place);
  phrase.insert(GliderLexer::RPAREN);
  return 3;
}

/// The tokens from token `first` to the end of the value there, for any tokens in it.
size_t tokensToEndOfValue(const Phrase& phrase, size_t first) {
  constexpr size_t kFarthest = 60;
  size_t deep = 0;
  for (size_t k = first; k < first + kFarthest; ++k) {
    const uint32_t type = phrase.type(k);
    const bool closes = oneOf(type, {GliderLexer::RPAREN, GliderLexer::RBRACKET});
    if ((closes && deep == 0) || phrase.startsLine(k) || isTransition(type) ||
        oneOf(type, {kEof, GliderLexer::DO, GliderLexer::END, GliderLexer::CASE})) {
      return k - first;
    }
    deep += oneOf(type, {GliderLexer::LPAREN, GliderLexer::LBRACKET}) ? 1U : 0U;
    deep -= closes ? 1U : 0U;
  }
  return 0;
}

/// `IF(depth > 10 m; 3; 4)`: a value takes its place, whose type is not checked.
size_t conditionalFunction(Phrase& phrase) {
  const bool called =
      (phrase.says(0, "if") || phrase.says(0, "iif")) && phrase.type(1) == GliderLexer::LPAREN;
  const uint32_t before = phrase.before();
  const bool inside = isOperator(before) || oneOf(before, {GliderLexer::ASSIGN, GliderLexer::LPAREN,
                                                           GliderLexer::COMMA, GliderLexer::CASE});
  const size_t inner = called && inside ? tokensToEndOfValue(phrase, 2) : 0;
  const bool three = std::ranges::any_of(std::views::iota(size_t{0}, inner), [&](size_t k) {
    return oneOf(phrase.type(2 + k), {GliderLexer::COMMA, GliderLexer::SEMICOLON});
  });
  if (!three || phrase.type(2 + inner) != GliderLexer::RPAREN) {
    return 0;
  }
  phrase.reporter()
      .at(phrase.token(), support::diagnostics::unexpectedToken, "a value",
          describe(phrase.source(), phrase.token()))
      .hint(std::string(kNoConditionalValue));
  const Lexeme whole = phrase.whole(0, inner + 3);
  phrase.put({GliderLexer::NAME, whole.begin, phrase.token().end});
  phrase.notAsMeant();
  return inner + 3;
}

/// `temp > if depth > 10 m then 3 degC else 4 degC`.
size_t conditionalWords(Phrase& phrase) {
  const bool inside = isOperator(phrase.before()) || phrase.before() == GliderLexer::ASSIGN;
  if (phrase.type() != GliderLexer::IF || !inside) {
    return 0;
  }
  const size_t tokens = tokensToEndOfValue(phrase, 0);
  const bool both = std::ranges::any_of(std::views::iota(size_t{0}, tokens), [&](size_t k) {
    return phrase.type(k) == GliderLexer::ELSE;
  });
  if (!both) {
    return 0;
  }
  phrase.reporter()
      .at(phrase.token(), support::diagnostics::unexpectedToken, "a value",
          describe(phrase.source(), phrase.token()))
      .hint(std::string(kNoConditionalValue));
  phrase.put({GliderLexer::NAME, phrase.token().begin, phrase.token().end});
  phrase.notAsMeant();
  // Its own `end`, if it has one.
  return tokens + (phrase.type(tokens) == GliderLexer::END && !phrase.startsLine(tokens) ? 1 : 0);
}

/// `30 % of the pack`: of what `energyleft` is a share is known.
size_t percentOfPack(Phrase& phrase) {
  const Lexeme* unit = phrase.lexemeBefore();
  const size_t the = phrase.says(1, "the") ? 1 : 0;
  const std::string word = phrase.lower(1 + the);
  const bool pack =
      word == "pack" || word == "battery" || word == "batteries" || word == "capacity";
  if (phrase.type() != GliderLexer::OF || unit == nullptr || phrase.source().text(*unit) != "%" ||
      !pack || phrase.isDeclared(phrase.text(1 + the))) {
    return 0;
  }
  const Lexeme written = phrase.whole(0, 2 + the);
  phrase.reporter()
      .at(written, support::diagnostics::superfluousWord, phrase.source().text(written),
          "after a share")
      .fix({phrase.source().file, unit->end, written.end}, "");
  return 2 + the;
}

}  // namespace

size_t percentOf(Phrase& phrase) {
  if (const size_t taken = percentOfPack(phrase)) {
    return taken;
  }
  const Lexeme* unit = phrase.lexemeBefore();
  // In a list of arguments it may be what a window goes over.
  const bool window = !phrase.open().empty() && phrase.open().back().arguments &&
                      isAnyName(phrase.type(1)) &&
                      oneOf(phrase.type(2), {GliderLexer::COMMA, GliderLexer::RPAREN});
  if (phrase.type() != GliderLexer::OF || window || unit == nullptr ||
      phrase.source().text(*unit) != "%" || !startsAnyValue(phrase.type(1))) {
    return 0;
  }
  phrase.reporter()
      .at(phrase.token(), support::diagnostics::wordOperator, phrase.text(), "*")
      .fix(phrase.source().range(phrase.token()), "*");
  phrase.put({GliderLexer::TIMES, phrase.token().begin, phrase.token().end});
  return 1;
}

size_t arithmeticWords(Phrase& phrase) {
  return phrase.readsValues() ? firstOf(phrase, {wordForSign, readingAtDepth, distanceTo}) : 0;
}

size_t conditionalValue(Phrase& phrase) {
  return phrase.readsValues() ? firstOf(phrase, {conditionalFunction, conditionalWords}) : 0;
}

size_t questionMark(Phrase& phrase) {
  if (phrase.text() != "?" || !phrase.readsValues() || !endsValue(phrase.before())) {
    return 0;
  }
  const size_t tokens = tokensToEndOfValue(phrase, 0);
  const bool two = std::ranges::any_of(std::views::iota(size_t{0}, tokens), [&](size_t k) {
    return phrase.type(k) == GliderLexer::COLON;
  });
  if (!two) {
    return 0;
  }
  phrase.reporter()
      .at(phrase.token(), support::diagnostics::unexpectedToken, "an operator",
          describe(phrase.source(), phrase.token()))
      .hint(std::string(kNoConditionalValue));
  phrase.notAsMeant();
  return tokens;
}

size_t numberWord(Phrase& phrase) {
  if (endsValue(phrase.before()) || !isAnyName(phrase.type(1))) {
    return 0;
  }
  const auto* word = std::find_if(kNumberWords.begin() + 1, kNumberWords.end(),
                                  [&](std::string_view one) { return phrase.says(0, one); });
  if (word == kNumberWords.end() || phrase.startsLine(1) || unitForWord(phrase.text(1)).empty() ||
      phrase.isDeclared(phrase.text())) {
    return 0;
  }
  const Lexeme written = phrase.token();
  const std::string number = std::to_string(word - kNumberWords.begin());
  phrase.reporter()
      .at(written, support::diagnostics::unexpectedToken, "a number",
          describe(phrase.source(), written))
      .hint(fmt::format("write `{} {}`", number, phrase.text(1)))
      .fix(phrase.source().range(written), number);
  phrase.put({GliderLexer::NUMBER, written.begin, written.end});
  phrase.notAsMeant();
  return 1;
}

}  // namespace glider::frontend::phrases
