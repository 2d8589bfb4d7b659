// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Visits to states, and how many of them, as pilots write them.

#include "frontend/parse/phrases/promises/parts.h"
#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <string>

namespace glider::frontend::phrases {
namespace {

/// Whether token `k` is the name of a state, and no word of a promise.
bool namesState(const Phrase& phrase, size_t k) {
  return oneOf(phrase.type(k),
               {GliderLexer::NAME, GliderLexer::UNIT, GliderLexer::COMPASS, GliderLexer::MIN}) &&
         isStateName(phrase.source(), phrase.text(k));
}

/// In place of the next `count` tokens, a promise that is always kept.
size_t putPromise(Phrase& phrase, size_t count) {
  const Lexeme whole = phrase.whole(0, count);
  phrase.put({GliderLexer::ALWAYS, whole.begin, whole.begin});
  phrase.put({GliderLexer::TRUE, whole.begin, whole.end});
  phrase.notAsMeant();
  return count;
}

}  // namespace

size_t neverMoreTimes(Phrase& phrase) {
  constexpr std::string_view kMore = "more than";
  const bool first = tokensOfWords(phrase, 1, kMore) > 0;  // `never more than 2 back`
  const size_t number = first ? 3 : 4;
  const size_t times = phrase.type(number + 1) == GliderLexer::TIMES_WORD ? 1 : 0;
  const size_t state = first ? number + 1 + times : 1;
  const size_t count = first ? state + 1 : number + 1 + times;
  const bool more = first || (times == 1 && tokensOfWords(phrase, 2, kMore) > 0);
  if (phrase.type() != GliderLexer::NEVER || !more || phrase.type(number) != GliderLexer::NUMBER ||
      !namesState(phrase, state) || !phrase.startsLine(count)) {
    return 0;
  }
  const std::string better =
      fmt::format("visit {} at most {} times", phrase.text(state), phrase.text(number));
  expected(phrase, phrase.token(), "`visit`")
      .hint(fmt::format("write `require {}`", better))
      .fix(phrase.source().range(phrase.whole(0, count)), better);
  return putPromise(phrase, count);
}

size_t eventually(Phrase& phrase) {
  const bool word = phrase.says(0, "eventually") || phrase.says(0, "finally");
  const size_t line = phrase.tokensOfLine();
  size_t within = 1;
  while (within < line && phrase.type(within) != GliderLexer::WITHIN) {
    ++within;
  }
  if (!word || !readsAsValue(phrase, 1, within - 1)) {
    return 0;
  }
  const Lexeme found = phrase.token();
  auto report = expected(phrase, found, "`visit`");
  if (within == line) {
    report.hint(
        fmt::format("write `require visit {} within …`, with the longest time that it may "
                    "take",
                    phrase.wholeText(1, line - 1)));
    return putPromise(phrase, line);
  }
  report.hint(fmt::format("write `require visit {}`", phrase.wholeText(1, line - 1)))
      .fix(phrase.source().range(found), "visit");
  phrase.put({GliderLexer::VISIT, found.begin, found.end});
  return 1;
}

size_t exitAsPlace(Phrase& phrase) {
  const bool after =
      oneOf(phrase.before(), {GliderLexer::THEN, GliderLexer::VISIT, GliderLexer::UNTIL});
  if (phrase.type() != GliderLexer::EXIT || !after || phrase.startsLine()) {
    return 0;
  }
  const Lexeme word = phrase.token();
  const size_t number =
      phrase.type(1) == GliderLexer::WITHIN ? tokensOfQuantity(phrase, 2) : size_t{0};
  const std::string_view time = number == 0 ? "TIME" : phrase.wholeText(2, number);
  auto report = expected(phrase, word, "a state or a condition");
  if (phrase.before() == GliderLexer::VISIT) {
    report.hint(fmt::format("`exit` is not a place: write `require exit within {}`", time));
  } else {
    // The time is counted from the condition before it, not from the start of the mission.
    report.hint(
        fmt::format("`exit` is not a place: write `{} STATE within {} or exit`, or "
                    "`require exit within TIME` for the whole mission",
                    phrase.source().text(*phrase.lexemeBefore()), time));
  }
  phrase.put({GliderLexer::TRUE, word.begin, word.end});
  phrase.notAsMeant();
  return 1;
}

namespace {

/// How a promise of the area or state `name` is written that is never entered, or never left;
/// empty: it is neither.
std::string insteadOfEntering(Phrase& phrase, std::string_view name, bool leaves) {
  if (phrase.isArea(name)) {
    return fmt::format("always {}inside({})", leaves ? "" : "!", name);
  }
  return !leaves && isStateName(phrase.source(), name) ? fmt::format("never {}", name) : "";
}

}  // namespace

size_t neverEnters(Phrase& phrase) {
  constexpr std::string_view kEnter[] = {"enter",   "enters",    "entering", "be inside",
                                         "go into", "goes into", "inside",   "in"};
  constexpr std::string_view kLeave[] = {"leave",      "leaves",  "leaving",
                                         "be outside", "outside", "outside of"};
  const size_t enter = tokensOfOne(phrase, 1, kEnter);
  const size_t words = enter != 0 ? enter : tokensOfOne(phrase, 1, kLeave);
  const size_t article = phrase.says(1 + words, "the") ? 1 : 0;
  const size_t place = 1 + words + article;
  if (phrase.type() != GliderLexer::NEVER || words == 0 || !isAnyName(phrase.type(place)) ||
      phrase.startsLine(1) || phrase.startsLine(place) || !phrase.startsLine(place + 1)) {
    return 0;
  }
  const Lexeme found = phrase.token(1);
  const std::string better = insteadOfEntering(phrase, phrase.text(place), enter == 0);
  auto report = expected(phrase, found, "a state or a condition");
  if (better.empty()) {
    report.hint("`never` takes a state or a condition, as in `require never depth > 60 m`");
  } else {
    report.hint(fmt::format("write `require {}`", better))
        .fix(phrase.source().range(phrase.whole(0, place + 1)), better);
  }
  return putPromise(phrase, place + 1);
}

size_t placesWithoutComma(Phrase& phrase) {
  const bool list = oneOf(phrase.before(1), {GliderLexer::VISIT, GliderLexer::PATROL,
                                             GliderLexer::COMMA, GliderLexer::THEN});
  if (!oneOf(phrase.keyword(), {GliderLexer::REQUIRE, GliderLexer::THEN}) ||
      !phrase.open().empty() || !list ||
      !phrase.hasRead({GliderLexer::VISIT, GliderLexer::PATROL}) || !isAnyName(phrase.before()) ||
      phrase.startsLine() || !namesState(phrase, 0)) {
    return 0;
  }
  const std::string_view first = phrase.source().text(*phrase.lexemeBefore());
  if (!isStateName(phrase.source(), first)) {
    return 0;
  }
  const Lexeme found = phrase.token();
  const bool sequence = phrase.before(1) == GliderLexer::THEN;
  if (sequence) {
    expected(phrase, found, "`then`")
        .hint(fmt::format("write `{} then {}`", first, phrase.text()))
        .fix({phrase.source().file, found.begin, found.begin}, "then ");
  } else {
    // No fix: whether their order matters is not known.
    phrase.reporter()
        .at(found, support::diagnostics::missingComma, fmt::format("`{}`", first),
            fmt::format("`{}`", phrase.text()))
        .hint(phrase.before(1) == GliderLexer::COMMA
                  ? fmt::format("write `{}, {}`", first, phrase.text())
                  : fmt::format("write `{0}, {1}`, or `{0} then {1}` if the order matters", first,
                                phrase.text()));
  }
  phrase.insert(sequence ? GliderLexer::THEN : GliderLexer::COMMA);
  phrase.put(found);
  return 1;
}

}  // namespace glider::frontend::phrases
