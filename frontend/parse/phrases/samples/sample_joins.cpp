// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/samples/sample_parts.h"
#include "frontend/parse/token_kinds.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

// What stands between instruments and the parts that are about them.

namespace glider::frontend::phrases {
namespace {

/// `ctd on`, `ctd always`: an instrument that is named reads.
size_t wordForReading(Phrase& phrase) {
  const size_t words = tokensOfOne(
      phrase, 0,
      {"as fast as possible", "as often as possible", "all the time", "turned on", "switched on",
       "continuously", "continuous", "constantly", "always", "enabled", "fast", "fully", "on"});
  return words == 0 || phrase.startsLine()
             ? 0
             : leaveOutWords(phrase, words, "after an instrument: one that is named reads");
}

/// `ctd never`, `ctd switched off`.
size_t wordForOff(Phrase& phrase) {
  const size_t words = tokensOfOne(phrase, 0,
                                   {"never", "disabled", "none", "not", "no", "turned off",
                                    "switched off", "is off", "out", "idle"});
  if (words == 0) {
    return 0;
  }
  reportMeant(phrase, words, "off");
  const Lexeme written = phrase.whole(0, words);
  phrase.put({GliderLexer::OFF, written.begin, written.end});
  return words;
}

/// `ctd: off`, `ctd = off`.
size_t signBeforePart(Phrase& phrase) {
  const bool sign = oneOf(phrase.type(), {GliderLexer::COLON, GliderLexer::ASSIGN});
  return sign && beginsPart(phrase, 1) ? leaveOutWords(phrase, 1, "after an instrument") : 0;
}

/// `optode(off)`, `ctd (every 4 s)`.
size_t partInParentheses(Phrase& phrase) {
  size_t close = 1;
  const size_t line = phrase.tokensOfLine();
  while (close < line && phrase.type(close) != GliderLexer::RPAREN) {
    ++close;
  }
  if (phrase.type() != GliderLexer::LPAREN || close >= line || !beginsPart(phrase, 1)) {
    return 0;
  }
  const support::SourceRange open{phrase.source().file, phrase.lexemeBefore()->end,
                                  phrase.token().end};
  const std::string_view part = phrase.wholeText(1, close - 1);
  phrase.reporter()
      .at(phrase.token(), support::diagnostics::superfluousWord, "(", "after an instrument")
      .hint(fmt::format("write `{} {}`", phrase.source().text(*phrase.lexemeBefore()), part))
      .fix(open, " ")
      .fix(phrase.source().range(phrase.token(close)), "");
  phrase.leaveOut(close);
  return 1;
}

}  // namespace

size_t wordOfInstrument(Phrase& phrase) {
  return afterInstrument(phrase)
             ? firstOf(phrase, {wordForReading, wordForOff, signBeforePart, partInParentheses})
             : 0;
}

namespace {

/// Whether a sign or word joins two instruments, or two parts. `every gap + slack` is one value.
bool joinsInstruments(const Phrase& phrase) {
  const bool value =
      !afterInstrument(phrase) &&
      !oneOf(phrase.before(), {GliderLexer::OFF, GliderLexer::CLIMBS, GliderLexer::DIVES});
  return oneOf(phrase.type(), {GliderLexer::AND_WORD, GliderLexer::AND, GliderLexer::ONE_AMPERSAND,
                               GliderLexer::SEMICOLON}) ||
         phrase.says(0, "and") || (phrase.type() == GliderLexer::PLUS && !value);
}

/// Whether an instrument, with all that is about it, may begin with token `k`.
bool beginsInstrument(const Phrase& phrase, size_t k, bool certainly) {
  const bool name = isAnyName(phrase.type(k)) && !beginsPart(phrase, k);
  const bool often = phrase.type(k + 1) == GliderLexer::EVERY || phrase.says(k + 1, "off");
  return name && (often || (!certainly && (beginsPart(phrase, k + 1) || endsSample(phrase, k + 1) ||
                                           phrase.type(k + 1) == GliderLexer::COMMA)));
}

/// Whether the last part that was read is a condition, which may go on.
bool inCondition(const Phrase& phrase) {
  return phrase.before() != GliderLexer::SAMPLE && sampleItem(phrase).when > 0 &&
         !oneOf(phrase.before(), {GliderLexer::CLIMBS, GliderLexer::DIVES});
}

/// Whether a part certainly begins with token `k`: its words may also be names in a condition.
bool certainlyPart(const Phrase& phrase, size_t k) {
  const uint32_t next = phrase.type(k + 1);
  const bool side = tokensOfOne(phrase, k, {"below", "above"}) > 0;
  return phrase.type(k) == GliderLexer::EVERY || (phrase.says(k, "off") && !inCondition(phrase)) ||
         tokensOfOne(phrase, k, {"on climbs", "on dives", "on climb", "on dive", "one yo"}) > 0 ||
         (side && (next == GliderLexer::NUMBER || next == GliderLexer::NAME));
}

/// `ctd every 4 s and optode off`, `ctd on climbs and below 10 m`.
size_t joined(Phrase& phrase) {
  if (!joinsInstruments(phrase)) {
    return 0;
  }
  if (certainlyPart(phrase, 1)) {
    return leaveOutWords(phrase, 1, "between the parts of an instrument");
  }
  if (!beginsInstrument(phrase, 1, inCondition(phrase))) {
    return 0;
  }
  const Lexeme sign = phrase.token();
  phrase.reporter()
      .at(sign, support::diagnostics::unexpectedToken, "`,`", fmt::format("`{}`", phrase.text()))
      .hint("write `,` between instruments")
      .fix({phrase.source().file, phrase.lexemeBefore()->end, sign.end}, ",");
  phrase.put({GliderLexer::COMMA, sign.begin, sign.end});
  return 1;
}

/// `ctd off optode off`.
size_t leftOut(Phrase& phrase) {
  const bool unit = phrase.before() == GliderLexer::NUMBER || phrase.text() == "magnetic";
  if (phrase.type() != GliderLexer::NAME || unit ||
      !beginsInstrument(phrase, 0, !phrase.startsLine() || inCondition(phrase))) {
    return 0;
  }
  const Lexeme before = *phrase.lexemeBefore();
  const Lexeme name = phrase.token();
  phrase.reporter()
      .at(name, support::diagnostics::missingComma,
          fmt::format("`{}`", phrase.source().text(before)), fmt::format("`{}`", phrase.text()))
      .fix({phrase.source().file, before.end, before.end}, ",");
  phrase.put({GliderLexer::COMMA, before.end, before.end});
  phrase.put(name);
  return 1;
}

/// `ctd every 4 s, on climbs`.
size_t commaBeforePart(Phrase& phrase) {
  if (phrase.type() == GliderLexer::COMMA && phrase.says(1, "unless")) {
    return 1;  // the next repair reports it
  }
  const bool number = tokensOfNumber(phrase, 2) > 0;
  const bool part = phrase.type() == GliderLexer::COMMA && !phrase.startsLine(1) &&
                    (phrase.type(1) == GliderLexer::EVERY ||
                     tokensOfOne(phrase, 1, {"on climbs", "on dives", "one yo"}) > 0 ||
                     (number && tokensOfOne(phrase, 1, {"below", "above"}) > 0));
  return part ? leaveOutWords(phrase, 1, "between the parts of an instrument") : 0;
}

/// `when diving only`.
size_t onlyAtEnd(Phrase& phrase) {
  const bool end = endsSample(phrase, 1) || phrase.type(1) == GliderLexer::COMMA;
  return phrase.type() == GliderLexer::ONLY && end
             ? leaveOutWords(phrase, 1, "after the parts of an instrument")
             : 0;
}

}  // namespace

size_t sampleComma(Phrase& phrase) {
  return mayBeginPart(phrase) ? firstOf(phrase, {joined, leftOut, commaBeforePart, onlyAtEnd}) : 0;
}

}  // namespace glider::frontend::phrases
