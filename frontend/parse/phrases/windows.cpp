// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"
#include "support/diagnostics/ids/syntax.h"
#include "support/one_of.h"

#include <fmt/format.h>

#include <initializer_list>
#include <string>

namespace glider::frontend::phrases {
namespace {

bool isNamedOneOf(const Phrase& phrase, size_t k, std::initializer_list<std::string_view> words) {
  return phrase.type(k) == GliderLexer::NAME && support::isOneOf(phrase.text(k), words);
}

/// Whether two names after a comma can only be meant as a leg: `highest(temp, last yo)`.
bool isMeantAsLeg(const Phrase& phrase) {
  return isNamedOneOf(phrase, 0, {"this", "last", "previous"}) &&
         phrase.type(1) == GliderLexer::NAME && !phrase.open().empty() &&
         phrase.open().back().arguments;
}

/// Reports what is like a leg: `previous leg`, `last yo`, `this leg of depth`.
void refuseLeg(Phrase& phrase, size_t tokens, bool known) {
  const std::string which = phrase.text() == "this" ? "this" : "last";
  const Lexeme written = phrase.whole(0, tokens);
  const std::string better = known ? fmt::format("`{} {}`", which, phrase.text(1))
                                   : fmt::format("`{0} leg`, `{0} dive` or `{0} climb`", which);
  phrase.reporter().at(written, support::diagnostics::notALeg, phrase.source().text(written),
                       better);
  phrase.notAsMeant();
}

/// `highest(this dive, chlorophyll)`, right after the parenthesis.
size_t legFirst(Phrase& phrase) {
  const bool leg = isNamedOneOf(phrase, 0, {"this", "last"}) &&
                   isNamedOneOf(phrase, 1, {"leg", "dive", "climb"}) &&
                   phrase.type(2) == GliderLexer::COMMA;
  const bool sensor = phrase.type(3) == GliderLexer::NAME && phrase.type(4) == GliderLexer::RPAREN;
  if (!leg || !sensor || !isAnyName(phrase.before(1))) {
    return 0;
  }
  const Lexeme window = phrase.whole(0, 2, GliderLexer::NAME);
  const Lexeme whole = phrase.whole(0, 4);
  const std::string better = fmt::format("{}, {}", phrase.text(3), phrase.source().text(window));
  phrase.reporter()
      .at(window, support::diagnostics::unexpectedToken, "a sensor",
          fmt::format("`{}`", phrase.source().text(window)))
      .hint(fmt::format("write `{}({})`", phrase.source().text(*phrase.lexemeBefore(1)), better))
      .fix(phrase.source().range(whole), better);
  phrase.put(phrase.token(3));
  phrase.put(phrase.token(2));
  phrase.put(window);
  return 4;
}

/// `mean(chlorophyll, last 3 dives)`.
size_t lastDives(Phrase& phrase) {
  const bool several = isNamedOneOf(phrase, 0, {"last", "past", "previous"}) &&
                       phrase.type(1) == GliderLexer::NUMBER &&
                       isNamedOneOf(phrase, 2, {"dives", "climbs", "legs", "yos", "profiles"}) &&
                       phrase.type(3) == GliderLexer::RPAREN;
  if (!several) {
    return 0;
  }
  const Lexeme written = phrase.whole(0, 3);
  phrase.reporter().at(written, support::diagnostics::notALeg, phrase.source().text(written),
                       "`this dive` or `last dive`; for more of them keep the value of each dive "
                       "in an array");
  phrase.notAsMeant();
  phrase.put({GliderLexer::NAME, phrase.token().begin, phrase.token().end});
  return 3;
}

/// `mean(temp, last 5 min)`.
size_t lastOfTime(Phrase& phrase) {
  const size_t number = tokensOfNumber(phrase, 1);
  if (!isNamedOneOf(phrase, 0, {"last", "past", "previous"}) || number < 2 ||
      phrase.type(1 + number) != GliderLexer::RPAREN || phrase.open().empty() ||
      !phrase.open().back().arguments) {
    return 0;
  }
  const Lexeme word = phrase.token();
  phrase.reporter()
      .at(word, support::diagnostics::superfluousWord, phrase.text(),
          fmt::format("before `{}`", phrase.wholeText(1, number)))
      .fix({phrase.source().file, word.begin, phrase.token(1).begin}, "");
  return 1;
}

/// `max(chlorophyll, this dive)`: the function of a window has another name. The leg comes next.
void refuseGreatest(Phrase& phrase) {
  const bool call = phrase.before(2) == GliderLexer::LPAREN && phrase.lexemeBefore(3) != nullptr;
  const std::string_view name =
      call ? phrase.source().text(*phrase.lexemeBefore(3)) : std::string_view();
  if (name != "max" && name != "min") {
    return;
  }
  const Lexeme callee = *phrase.lexemeBefore(3);
  const std::string_view better = name == "max" ? "highest" : "lowest";
  phrase.reporter()
      .at(callee, support::diagnostics::unexpectedToken, fmt::format("`{}`", better),
          describe(phrase.source(), callee))
      .hint(fmt::format("write `{}({}, {})`", better, phrase.source().text(*phrase.lexemeBefore(1)),
                        phrase.wholeText(0, 2)))
      .fix(phrase.source().range(callee), std::string(better));
  phrase.notAsMeant();
}

}  // namespace

size_t leg(Phrase& phrase) {
  if (phrase.before() == GliderLexer::LPAREN) {
    return legFirst(phrase);
  }
  if (phrase.before() == GliderLexer::COMMA && phrase.type(1) != GliderLexer::NAME) {
    return firstOf(phrase, {lastDives, lastOfTime});
  }
  if (phrase.before() != GliderLexer::COMMA || phrase.type(1) != GliderLexer::NAME) {
    return 0;
  }
  const bool known = isNamedOneOf(phrase, 1, {"leg", "dive", "climb"});
  const bool which = isNamedOneOf(phrase, 0, {"this", "last"});
  const bool of = phrase.type(2) == GliderLexer::OF && phrase.type(3) == GliderLexer::NAME;
  if (!isMeantAsLeg(phrase) && !(which && known && phrase.type(2) == GliderLexer::RPAREN)) {
    return 0;
  }
  const size_t tokens = of ? 4 : 2;
  if (which && known && !of) {
    refuseGreatest(phrase);
  }
  if (!which || !known || of) {
    refuseLeg(phrase, tokens, known);
  }
  phrase.put(phrase.whole(0, 2, GliderLexer::NAME));
  return tokens;
}

size_t part(Phrase& phrase) {
  const bool parts = isAnyName(phrase.type()) && phrase.type(1) == GliderLexer::FOREIGN &&
                     phrase.text(1) == "." && phrase.touches(1) && isAnyName(phrase.type(2)) &&
                     phrase.touches(2);
  if (!parts || wantsName(phrase.before())) {
    return 0;
  }
  const Lexeme whole = phrase.whole(0, 3);
  const bool called = phrase.type(3) == GliderLexer::LPAREN && phrase.touches(3);
  const bool empty = called && phrase.type(4) == GliderLexer::RPAREN;
  const std::string better = !called ? std::string(phrase.text(2))
                             : empty ? fmt::format("{}({})", phrase.text(2), phrase.text())
                                     : fmt::format("{}({}, …)", phrase.text(2), phrase.text());
  phrase.reporter().at(whole, support::diagnostics::nameNotOneWord, phrase.source().text(whole),
                       fmt::format("write `{}`", better));
  phrase.put(phrase.token(2));
  if (called) {
    phrase.notAsMeant();
  }
  return 3;
}

/// Before it there must be a window with nothing but a name in it: `mean(temp`.
size_t wordOfWindow(Phrase& phrase) {
  const bool first = phrase.before(1) == GliderLexer::LPAREN && isName(phrase.before());
  const size_t number = first ? tokensOfNumber(phrase, 1) : 0;
  if (number == 0) {
    return 0;
  }
  const bool says_length =
      support::isOneOf(phrase.text(), {"over", "within", "during", "for", "in"});
  const bool compares = support::isOneOf(phrase.text(), {"under", "below", "above"});
  if (!says_length && !compares) {
    return 0;
  }
  const std::string_view function = phrase.source().text(*phrase.lexemeBefore(2));
  if (!support::isOneOf(function, {"mean", "lowest", "highest", "spread", "slope"})) {
    return 0;
  }
  const std::string_view unit = phrase.text(number);
  const bool time = support::isOneOf(unit, {"s", "min", "h", "day", "days"});
  const Lexeme word = phrase.token();
  const std::string length(phrase.wholeText(1, number));
  const std::string better = time ? length : length + " of depth";
  auto report = phrase.reporter().at(word, support::diagnostics::unexpectedToken, "`,`",
                                     fmt::format("`{}`", phrase.text()));
  report.hint(fmt::format("write `{}({}, {})`", function,
                          phrase.source().text(*phrase.lexemeBefore()), better));
  if (says_length && time) {
    report.fix({phrase.source().file, phrase.lexemeBefore()->end, word.end}, ",");
  }
  phrase.put({GliderLexer::COMMA, word.begin, word.end});
  if (!time) {
    phrase.notAsMeant();
  }
  return 1;
}

}  // namespace glider::frontend::phrases
