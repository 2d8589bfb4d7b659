// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"
#include "frontend/spelling.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

namespace glider::frontend::phrases {
namespace {

support::DiagnosticBuilder missing(Phrase& phrase, const Lexeme& at, std::string_view first,
                                   std::string_view second) {
  return phrase.reporter().at(at, support::diagnostics::missingComma, fmt::format("`{}`", first),
                              fmt::format("`{}`", second));
}

/// `distance(home), depth`: a command has nothing after it, so a comma makes it a value.
bool isCallInList(const Phrase& phrase) {
  const size_t line = phrase.tokensOfLine();
  if (phrase.type() != GliderLexer::NAME || phrase.type(1) != GliderLexer::LPAREN) {
    return false;
  }
  size_t deep = 0;
  for (size_t k = 1; k < line; ++k) {
    deep += phrase.type(k) == GliderLexer::LPAREN ? 1U : 0U;
    deep -= phrase.type(k) == GliderLexer::RPAREN ? 1U : 0U;
    if (deep == 0) {
      return phrase.type(k + 1) == GliderLexer::COMMA;
    }
  }
  return false;
}

}  // namespace

size_t andOfSensors(Phrase& phrase) {
  const bool both = oneOf(phrase.type(), {GliderLexer::AND_WORD, GliderLexer::AND,
                                          GliderLexer::ONE_AMPERSAND, GliderLexer::PLUS});
  // Not in `every …`, which may be any value.
  const bool sensor = isAnyName(phrase.before()) &&
                      oneOf(phrase.before(1), {GliderLexer::SENSORS, GliderLexer::COMMA});
  if (!both || phrase.keyword() != GliderLexer::SENSORS || !phrase.open().empty() || !sensor ||
      !isAnyName(phrase.type(1))) {
    return 0;
  }
  const Lexeme sign = phrase.token();
  const Lexeme before = *phrase.lexemeBefore();
  const std::string_view first = phrase.source().text(before);
  missing(phrase, sign, first, phrase.text(1))
      .hint(fmt::format("write `{}, {}`", first, phrase.text(1)))
      .fix({phrase.source().file, before.end, sign.end}, ",");
  phrase.put({GliderLexer::COMMA, sign.begin, sign.end});
  return 1;
}

size_t textWithoutOpeningQuote(Phrase& phrase) {
  if (phrase.before() != GliderLexer::LOG || phrase.startsLine()) {
    return 0;
  }
  const size_t line = phrase.tokensOfLine();
  size_t k = 0;
  while (k < line && !oneOf(phrase.type(k), {GliderLexer::COMMA, GliderLexer::STRING, kEof,
                                             GliderLexer::OPEN_STRING})) {
    ++k;
  }
  if (k == 0 || k >= line || phrase.type(k) != GliderLexer::OPEN_STRING || !phrase.touches(k)) {
    return 0;
  }
  // No fix: what of it is the text is for the pilot to say.
  const Lexeme rest = phrase.token(k);
  const Lexeme text{GliderLexer::STRING, phrase.token().begin, rest.begin + 1};
  const std::string_view whole = phrase.source().text().substr(0, rest.end);
  phrase.reporter()
      .at(text, support::diagnostics::unexpectedToken, "a text in quotes",
          describe(phrase.source(), phrase.token()))
      .hint(fmt::format("write `\"{}`", phrase.source().text(text)));
  phrase.put(text);
  for (const Lexeme& one : lex(whole, rest.begin + 1)) {
    if (one.type != kEof) {
      phrase.put(one);
    }
  }
  return k + 1;
}

size_t eachForEvery(Phrase& phrase) {
  const bool each = phrase.says(0, "each") && phrase.keyword() == GliderLexer::SENSORS;
  if (!each || phrase.startsLine() || !endsValue(phrase.before()) ||
      tokensOfNumber(phrase, 1) == 0) {
    return 0;
  }
  const Lexeme word = phrase.token();
  phrase.reporter()
      .at(word, support::diagnostics::misspelledKeyword, phrase.text(), "every")
      .fix(phrase.source().range(word), "every");
  phrase.put({GliderLexer::EVERY, word.begin, word.end});
  return 1;
}

size_t everyBeforeSensor(Phrase& phrase) {
  const size_t number = tokensOfNumber(phrase, 1);
  const size_t sensor = number + 1;
  const bool item = oneOf(phrase.before(), {GliderLexer::SENSORS, GliderLexer::COMMA}) &&
                    phrase.keyword() == GliderLexer::SENSORS && phrase.open().empty();
  const bool last = phrase.type(sensor + 1) == GliderLexer::COMMA || phrase.startsLine(sensor + 1);
  if (!item || number == 0 || !isAnyName(phrase.type(sensor)) || phrase.startsLine(sensor) ||
      !last) {
    return 0;
  }
  const Lexeme written = phrase.whole(0, sensor + 1);
  const std::string better =
      fmt::format("{} {}", phrase.text(sensor), phrase.wholeText(0, number + 1));
  auto report =
      phrase.reporter().at(phrase.whole(0, number + 1), support::diagnostics::unexpectedToken,
                           "a sensor", fmt::format("`{}`", phrase.wholeText(0, number + 1)));
  if (phrase.before() == GliderLexer::SENSORS && phrase.type(sensor + 1) == GliderLexer::COMMA) {
    // For all of them, or for the first?
    report.hint(fmt::format("write `{}` after each sensor that it is for, as in `{}`",
                            phrase.wholeText(0, number + 1), better));
  } else {
    report.hint(fmt::format("write `{}`", better)).fix(phrase.source().range(written), better);
  }
  phrase.put(phrase.token(sensor));
  for (size_t k = 0; k <= number; ++k) {
    phrase.put(phrase.token(k));
  }
  return sensor + 1;
}

size_t unitAfterSensor(Phrase& phrase) {
  const bool sensor = phrase.keyword() == GliderLexer::SENSORS && isAnyName(phrase.before()) &&
                      oneOf(phrase.before(1), {GliderLexer::SENSORS, GliderLexer::COMMA});
  if (!sensor || phrase.type() != GliderLexer::LPAREN || !isAnyName(phrase.type(1)) ||
      phrase.type(2) != GliderLexer::RPAREN) {
    return 0;
  }
  const Lexeme written = phrase.whole(0, 3);
  phrase.reporter()
      .at(written, support::diagnostics::superfluousWord, phrase.source().text(written),
          "after a sensor")
      .hint("delete it: the unit of a sensor is known")
      .fix({phrase.source().file, phrase.lexemeBefore()->end, written.end}, "");
  return 3;
}

size_t valueAfterText(Phrase& phrase) {
  const bool after_text =
      phrase.before() == GliderLexer::STRING && phrase.before(1) == GliderLexer::LOG;
  // `log "deep", depth temp`.
  const bool second = phrase.keyword() == GliderLexer::LOG && phrase.open().empty() &&
                      phrase.before() == GliderLexer::NAME &&
                      phrase.before(1) == GliderLexer::COMMA && phrase.type() == GliderLexer::NAME;
  const uint32_t next = phrase.type(1);
  // What a statement begins with: `sample(…)`, and `n = 3` without its `set`.
  const bool statement = oneOf(
      next, {GliderLexer::LPAREN, GliderLexer::ASSIGN, GliderLexer::LBRACKET, GliderLexer::STRING});
  const bool value = oneOf(phrase.type(), {GliderLexer::NUMBER, GliderLexer::HEARD}) ||
                     (phrase.type() == GliderLexer::NAME && !statement) ||
                     (after_text && isCallInList(phrase));
  if (!(after_text || second) || !value || phrase.startsLine() ||
      !closest(phrase.text(), {"end", "set", "else", "log", "for", "exit"}).empty()) {
    return 0;
  }
  const Lexeme found = phrase.token();
  const Lexeme text = *phrase.lexemeBefore();
  missing(phrase, found, phrase.source().text(text), phrase.text())
      .fix({phrase.source().file, text.end, text.end}, ",");
  phrase.insert(GliderLexer::COMMA);
  phrase.put(found);
  return 1;
}

}  // namespace glider::frontend::phrases
