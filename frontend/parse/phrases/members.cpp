// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The members of a state: its route, its sensors, what it does on entry.

#include "frontend/bare_positions.h"
#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"
#include "support/diagnostics/ids/meaning.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace glider::frontend::phrases {
namespace {

/// Whether the members of a state are read, and none of its cases.
bool amongMembers(const Phrase& phrase) {
  return phrase.startsLine() && phrase.open().empty() &&
         oneOf(phrase.keyword(), {GliderLexer::FLIGHTPROFILE, GliderLexer::FLIGHTROUTE,
                                  GliderLexer::SENSORS, GliderLexer::BEGIN});
}

/// The tokens of `(home)` or `home` from token `k` on, with those of the value alone.
struct Place {
  size_t tokens = 0;
  size_t first = 0;
  size_t count = 0;
};

Place placeAt(const Phrase& phrase, size_t k) {
  const size_t line = phrase.tokensOfLine();
  if (phrase.type(k) != GliderLexer::LPAREN) {
    return k < line && startsValue(phrase.type(k)) && readsAsValue(phrase, k, line - k)
               ? Place{line - k, k, line - k}
               : Place{};
  }
  const size_t count = tokensOfValue(phrase, k + 1, false);
  const bool closed = phrase.type(k + 1 + count) == GliderLexer::RPAREN;
  return closed && count > 0 && k + 2 + count == line ? Place{count + 2, k + 1, count} : Place{};
}

}  // namespace

size_t routeToPlace(Phrase& phrase) {
  constexpr std::array<std::string_view, 6> kWords = {"go to",   "goto",   "to",
                                                      "towards", "toward", "waypoint"};
  if (phrase.before() != GliderLexer::FLIGHTROUTE) {
    return 0;
  }
  size_t words = 0;
  for (const std::string_view one : kWords) {
    words = words == 0 ? tokensOfWords(phrase, 0, one) : words;
  }
  const Place place = words == 0 ? Place{} : placeAt(phrase, words);
  // A route may have the name `to`, but not `goto`.
  const bool called = phrase.type(words) == GliderLexer::LPAREN;
  const bool keyword = phrase.type() == GliderLexer::GOTO || words > 1;
  if (place.tokens == 0 || (called && !keyword)) {
    return 0;
  }
  const Lexeme name = phrase.whole(0, words, GliderLexer::NAME);
  const std::string better = fmt::format("nav({})", phrase.wholeText(place.first, place.count));
  phrase.reporter()
      .at(name, support::diagnostics::unknownProfileOrRoute, "flightroute",
          phrase.source().text(name), fmt::format("write `{}`", better))
      .fix(phrase.source().range(phrase.whole(0, words + place.tokens)), better);
  phrase.put(name);
  phrase.insert(GliderLexer::LPAREN);
  for (size_t k = place.first; k < place.first + place.count; ++k) {
    phrase.put(phrase.token(k));
  }
  phrase.insert(GliderLexer::RPAREN);
  phrase.notAsMeant();
  return words + place.tokens;
}

size_t rateOfSensor(Phrase& phrase) {
  const bool sensor = phrase.keyword() == GliderLexer::SENSORS && isAnyName(phrase.before()) &&
                      oneOf(phrase.before(1), {GliderLexer::SENSORS, GliderLexer::COMMA});
  const bool hertz = sensor && phrase.type(1) == GliderLexer::NUMBER && phrase.says(2, "hz");
  const size_t time = hertz || !sensor ? 0 : tokensOfQuantity(phrase, 1);
  const bool at = phrase.type() == GliderLexer::AT && time > 1;
  const double rate = hertz ? valueOf(phrase.text(1)) : 0;
  if (!(at || rate > 0)) {
    return 0;
  }
  const Lexeme written = phrase.whole(0, hertz ? 3 : 1 + time);
  const std::string better = hertz ? fmt::format("every {:.4g} s", 1 / rate)
                                   : fmt::format("every {}", phrase.wholeText(1, time));
  phrase.reporter()
      .at(written, support::diagnostics::unexpectedToken, "`,` or the next line",
          fmt::format("`{}`", phrase.source().text(written)))
      .hint(fmt::format("write `{} {}`", phrase.source().text(*phrase.lexemeBefore()), better))
      .fix(phrase.source().range(written), better);
  phrase.notAsMeant();
  return hertz ? 3 : 1 + time;
}

size_t wordForSensors(Phrase& phrase) {
  constexpr std::array<std::string_view, 5> kWords = {"sample", "record", "measure", "sense",
                                                      "read"};
  const bool list = isAnyName(phrase.type(1)) && !phrase.startsLine(1) &&
                    (phrase.type(2) == GliderLexer::COMMA || phrase.startsLine(2));
  if (!amongMembers(phrase) || !list ||
      std::ranges::none_of(kWords, [&](auto word) { return phrase.says(0, word); }) ||
      phrase.before() == GliderLexer::COMMA) {
    return 0;
  }
  const Lexeme word = phrase.token();
  phrase.reporter()
      .at(word, support::diagnostics::misspelledKeyword, phrase.text(), "sensors")
      .hint(fmt::format("write `sensors {} …`", phrase.text(1)))
      .fix(phrase.source().range(word), "sensors");
  phrase.put({GliderLexer::SENSORS, word.begin, word.end});
  return 1;
}

size_t wordBeforeEntry(Phrase& phrase) {
  const bool word = phrase.says(0, "on") || phrase.says(0, "at") || phrase.says(0, "upon");
  // On a line of its own it is the last sensor of a list.
  if (!word || phrase.type(1) != GliderLexer::ENTRY || !phrase.startsLine() ||
      phrase.startsLine(1)) {
    return 0;
  }
  phrase.reporter()
      .at(phrase.token(), support::diagnostics::superfluousWord, phrase.text(), "before `entry`")
      .fix({phrase.source().file, phrase.token().begin, phrase.token(1).begin}, "");
  return 1;
}

namespace {

/// Whether the last part of a state that was read is not its events.
bool beforeEvents(const Phrase& phrase) {
  constexpr size_t kFarthest = 300;
  for (size_t k = 0; k < kFarthest && phrase.before(k) != 0; ++k) {
    if (oneOf(phrase.before(k), {GliderLexer::EVENTS, GliderLexer::CASE, GliderLexer::ALWAYS})) {
      return false;
    }
    if (startsMember(phrase.before(k))) {
      return true;
    }
  }
  return false;
}

}  // namespace

size_t blockOfLeaving(Phrase& phrase) {
  if (!phrase.startsLine() || !beforeEvents(phrase) || phrase.type(1) != GliderLexer::DO) {
    return 0;
  }
  constexpr size_t kFarthest = 200;
  size_t deep = 1;
  size_t k = 2;
  for (; k < kFarthest && deep > 0 && phrase.type(k) != kEof; ++k) {
    deep += oneOf(phrase.type(k), {GliderLexer::DO, GliderLexer::IF}) ? 1U : 0U;
    deep -= phrase.type(k) == GliderLexer::END ? 1U : 0U;
  }
  if (deep > 0) {
    return 0;
  }
  phrase.reporter()
      .at(phrase.token(), support::diagnostics::unexpectedToken,
          "`flightroute`, `flightprofile`, `sensors`, `events` or `end`",
          describe(phrase.source(), phrase.token()))
      .hint(
          "what is to be done on leaving belongs to the case that leaves: `case … do … end goto "
          "…`");
  return k;
}

size_t unitAfterName(Phrase& phrase) {
  const uint32_t next = phrase.type(1);
  const bool ends = isTransition(next) || isOperator(next) || phrase.startsLine(1) ||
                    oneOf(next, {GliderLexer::COMMA, GliderLexer::RPAREN, GliderLexer::DO});
  const bool value =
      isOperator(phrase.before(1)) ||
      oneOf(phrase.before(1), {GliderLexer::ASSIGN, GliderLexer::COMMA, GliderLexer::LPAREN});
  if (phrase.before() != GliderLexer::NAME || !value || !ends || phrase.startsLine() ||
      isOperator(phrase.type()) ||
      !phrase.isDeclared(phrase.source().text(*phrase.lexemeBefore()))) {
    return 0;
  }
  // No fix: a constant without a unit is to get it where it is declared.
  const std::string_view name = phrase.source().text(*phrase.lexemeBefore());
  phrase.reporter()
      .at(phrase.token(), support::diagnostics::superfluousWord, phrase.text(),
          fmt::format("after `{}`", name))
      .hint(fmt::format("delete it: the unit stands where `{}` gets its value", name));
  return 1;
}

}  // namespace glider::frontend::phrases
