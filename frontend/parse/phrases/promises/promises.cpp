// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/promises/parts.h"
#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::frontend::phrases {

support::DiagnosticBuilder expected(Phrase& phrase, const Lexeme& found, std::string_view what) {
  return phrase.reporter().at(found, support::diagnostics::unexpectedToken, what,
                              describe(phrase.source(), found));
}

bool isComparisonSign(uint32_t type) {
  return (type >= GliderLexer::EQ && type <= GliderLexer::GT) || type == GliderLexer::ASSIGN;
}

/// The tokens of the condition from token `first` on, which ends its line; 0: there is none. After
/// it, on a later line, a declaration may begin with a word that is also a name.
size_t tokensOfWholeCondition(const Phrase& phrase, size_t first) {
  const size_t line = phrase.tokensOfLine() - first;
  const size_t value = tokensOfValue(phrase, first, false);
  for (const size_t count : {line, value}) {
    const bool ends = count == value || phrase.startsLine(first + count);
    if (ends && count > 0 && count <= value && readsAsValue(phrase, first, count)) {
      return count;
    }
  }
  return 0;
}

namespace {

/// `exits within`, `exit in`: the first two words of a promise, and those that are meant.
struct Slip {
  std::string_view word;
  std::string_view next;
  std::string_view meant;
  uint32_t type;
  std::string_view meant_next;
  uint32_t next_type;
};
constexpr uint32_t kWithin = GliderLexer::WITHIN;
constexpr uint32_t kEvery = GliderLexer::EVERY;
constexpr Slip kSlips[] = {
    {"exits", "within", "exit", GliderLexer::EXIT, "within", kWithin},
    {"ends", "within", "exit", GliderLexer::EXIT, "within", kWithin},
    {"end", "within", "exit", GliderLexer::EXIT, "within", kWithin},
    {"exit", "in", "exit", GliderLexer::EXIT, "within", kWithin},
    {"exit", "by", "exit", GliderLexer::EXIT, "within", kWithin},
    {"exit", "before", "exit", GliderLexer::EXIT, "within", kWithin},
    {"surfaced", "every", "surfaces", GliderLexer::SURFACES, "every", kEvery},
    {"surface", "every", "surfaces", GliderLexer::SURFACES, "every", kEvery},
    {"surface", "within", "surfaces", GliderLexer::SURFACES, "every", kEvery},
    {"surface", "in", "surfaces", GliderLexer::SURFACES, "every", kEvery},
    {"surfaces", "within", "surfaces", GliderLexer::SURFACES, "every", kEvery},
    {"surfaces", "in", "surfaces", GliderLexer::SURFACES, "every", kEvery}};

/// `depth below 55 m`, `depth is less than 55 m`: the words are errors of their own.
bool isComparedInWords(const Phrase& phrase) {
  constexpr std::string_view kWords[] = {"below", "above", "under", "over",    "less", "more",
                                         "at",    "is",    "stays", "greater", "no",   "not"};
  return phrase.type() == GliderLexer::NAME && !phrase.startsLine(1) &&
         std::ranges::any_of(kWords, [&](std::string_view word) { return phrase.says(1, word); });
}

/// `require depth <= 55 m`.
size_t alwaysLeftOut(Phrase& phrase) {
  const bool word =
      oneOf(phrase.type(),
            {GliderLexer::STACK, GliderLexer::CAN, GliderLexer::REACH, GliderLexer::SURFACES,
             GliderLexer::IN, GliderLexer::OUTSIDE, GliderLexer::BEFORE, GliderLexer::AFTER,
             GliderLexer::FROM, GliderLexer::VISIT, GliderLexer::PATROL, GliderLexer::NEVER,
             GliderLexer::WHENEVER, GliderLexer::WHEN, GliderLexer::HOLD});
  const size_t count = word ? 0 : tokensOfWholeCondition(phrase, 0);
  bool compares = count == 0 && !word && isComparedInWords(phrase);
  bool good = !compares;  // otherwise words of it are errors of their own
  for (size_t k = 0; k < count; ++k) {
    const uint32_t type = phrase.type(k);
    compares = compares || isComparisonSign(type);
    good = good && !oneOf(type, {GliderLexer::AND_WORD, GliderLexer::OR_WORD, GliderLexer::ASSIGN});
  }
  if (!compares) {
    return 0;
  }
  const Lexeme first = phrase.token();
  expected(phrase, first, "`always`")
      .hint(good ? fmt::format("write `require always {}`", phrase.wholeText(0, count))
                 : fmt::format("write `always` before `{}`", phrase.text()))
      .fix({phrase.source().file, first.begin, first.begin}, "always ");
  phrase.insert(GliderLexer::ALWAYS);
  phrase.put(first);
  return 1;
}

/// `require altitude > 5 m always`.
size_t alwaysAtEnd(Phrase& phrase) {
  const size_t line = phrase.tokensOfLine();
  const size_t count = line - 1;
  bool compares = false;
  for (size_t k = 0; k < count; ++k) {
    compares = compares || isComparisonSign(phrase.type(k));
  }
  if (count == 0 || phrase.type(count) != GliderLexer::ALWAYS ||
      phrase.type(line) == GliderLexer::CASE || !compares || !readsAsValue(phrase, 0, count)) {
    return 0;
  }
  const Lexeme first = phrase.token();
  const Lexeme always = phrase.token(count);
  expected(phrase, first, "`always`")
      .hint(fmt::format("write `require always {}`", phrase.wholeText(0, count)))
      .fix({phrase.source().file, first.begin, first.begin}, "always ")
      .fix({phrase.source().file, phrase.token(count - 1).end, always.end}, "");
  phrase.put({GliderLexer::ALWAYS, first.begin, first.begin});
  for (size_t k = 0; k < count; ++k) {
    phrase.put(phrase.token(k));
  }
  return line;
}

/// `require surface at least every 4 h`, `surface at least once every 4 h`.
size_t surfacingAtLeast(Phrase& phrase) {
  const bool words = (phrase.says(0, "surface") || phrase.says(0, "surfaces")) &&
                     phrase.says(1, "at") && phrase.says(2, "least");
  const size_t every = phrase.says(3, "once") ? 4 : 3;
  if (!words || phrase.type(every) != kEvery) {
    return 0;
  }
  const Lexeme whole = phrase.whole(0, every + 1);
  const Lexeme word = phrase.token(every);
  expected(phrase, phrase.token(), "`surfaces every`")
      .hint("write `require surfaces every …`")
      .fix(phrase.source().range(whole), "surfaces every");
  phrase.put({GliderLexer::SURFACES, whole.begin, phrase.token().end});
  phrase.put(word);
  return every + 1;
}

/// `<=`, `at most`, `no later than`: the tokens from token 1 on of what stands for `within` or
/// `every`.
size_t tokensOfMost(const Phrase& phrase) {
  constexpr std::string_view kWords[] = {"at most", "no later than", "not later than", "less than",
                                         "in at most"};
  if (oneOf(phrase.type(1),
            {GliderLexer::LE, GliderLexer::LT, GliderLexer::COLON, GliderLexer::ASSIGN})) {
    return 1;
  }
  return tokensOfOne(phrase, 1, kWords);
}

/// `require surfaces 4 times`: how often is not how far apart.
size_t surfacesTimes(Phrase& phrase) {
  if (phrase.type() != GliderLexer::SURFACES || phrase.type(1) != GliderLexer::NUMBER ||
      phrase.type(2) != GliderLexer::TIMES_WORD) {
    return 0;
  }
  constexpr size_t kTokens = 3;
  const Lexeme word = phrase.token();
  expected(phrase, phrase.token(1), "`every`")
      .hint("write the longest time between two of them, as in `require surfaces every 4 h`");
  phrase.put(word);
  phrase.put({kEvery, phrase.token(1).begin, phrase.token(1).begin});
  phrase.put({GliderLexer::NUMBER, phrase.token(1).begin, phrase.token(1).end});
  phrase.notAsMeant();
  return kTokens;
}

/// `require exit 13 h`, `require exit <= 13 h`, `require surfaces 4 h`: a number without its word.
size_t timeAlone(Phrase& phrase) {
  const bool exit = phrase.type() == GliderLexer::EXIT;
  const size_t sign = tokensOfMost(phrase);
  const size_t first = 1 + sign;
  const size_t number = tokensOfQuantity(phrase, first);
  if (!(exit || phrase.type() == GliderLexer::SURFACES) || number == 0) {
    return 0;
  }
  const Lexeme word = phrase.token();
  const Lexeme found = phrase.token(1);
  const std::string_view meant = exit ? "within" : "every";
  const std::string better =
      fmt::format("{} {} {}", phrase.text(), meant, phrase.wholeText(first, number));
  expected(phrase, found, fmt::format("`{}`", meant))
      .hint(fmt::format("write `require {}`", better))
      .fix(phrase.source().range(phrase.whole(0, first + number)), better);
  phrase.put(word);
  phrase.put({exit ? kWithin : kEvery, found.begin, sign > 0 ? found.end : found.begin});
  return first;
}

/// `require case low then homeward within 10 min`. No fix: `when` may be meant.
size_t caseAsWhenever(Phrase& phrase) {
  const bool word = oneOf(phrase.type(), {GliderLexer::CASE, GliderLexer::IF});
  const size_t count = word ? tokensOfValue(phrase, 1, false) : 0;
  if (count == 0 ||
      !oneOf(phrase.type(1 + count), {GliderLexer::THEN, GliderLexer::GOTO, GliderLexer::CALL})) {
    return 0;
  }
  const Lexeme keyword = phrase.token();
  expected(phrase, keyword, "`whenever`")
      .hint(fmt::format("write `require whenever {} then …`", phrase.wholeText(1, count)));
  phrase.put({GliderLexer::WHENEVER, keyword.begin, keyword.end});
  return 1;
}

/// `require the mission exits within 9 h`, `require the glider surfaces every 4 h`.
size_t subject(Phrase& phrase) {
  const size_t article = phrase.says(0, "the") ? 1 : 0;
  const bool named = phrase.says(article, "mission") || phrase.says(article, "glider") ||
                     phrase.says(article, "vehicle");
  const size_t verb = article + 1;
  const bool exits = phrase.says(verb, "exits") || phrase.says(verb, "exit") ||
                     phrase.says(verb, "ends") || phrase.says(verb, "end");
  const bool surfaces = phrase.says(verb, "surfaces") || phrase.says(verb, "surface");
  const uint32_t next = phrase.type(verb + 1);
  if (!named || !((exits && next == kWithin) || (surfaces && next == kEvery))) {
    return 0;
  }
  const Lexeme whole = phrase.whole(0, verb + 2);
  const Lexeme last = phrase.token(verb + 1);
  const char* meant = exits ? "exit within" : "surfaces every";
  expected(phrase, phrase.token(), fmt::format("`{}`", meant))
      .hint(fmt::format("write `require {} …`", meant))
      .fix(phrase.source().range(whole), meant);
  phrase.put({exits ? GliderLexer::EXIT : GliderLexer::SURFACES, whole.begin, last.begin});
  phrase.put(last);
  return verb + 2;
}

/// `require visits report within 2 h`.
size_t visits(Phrase& phrase) {
  if (!phrase.says(0, "visits") || !isAnyName(phrase.type(1))) {
    return 0;
  }
  const Lexeme word = phrase.token();
  phrase.reporter()
      .at(word, support::diagnostics::misspelledKeyword, phrase.text(), "visit")
      .fix(phrase.source().range(word), "visit");
  phrase.put({GliderLexer::VISIT, word.begin, word.end});
  return 1;
}

/// `require within 7 h exit`, `require every 4 h surfaces`.
size_t timeFirst(Phrase& phrase) {
  const bool within = phrase.type() == kWithin;
  const size_t time = within || phrase.type() == kEvery ? tokensOfQuantity(phrase, 1) : 0;
  const bool surfaces = phrase.says(1 + time, "surfaces") || phrase.says(1 + time, "surface");
  if (time == 0 || !(within ? phrase.type(1 + time) == GliderLexer::EXIT : surfaces)) {
    return 0;
  }
  const std::string_view word = within ? "exit" : "surfaces";
  const Lexeme first = phrase.token();
  const Lexeme whole = phrase.whole(0, time + 2);
  const std::string better = fmt::format("{} {}", word, phrase.wholeText(0, time + 1));
  expected(phrase, first, within ? "`exit within`" : "`surfaces every`")
      .hint(fmt::format("write `require {}`", better))
      .fix(phrase.source().range(whole), better);
  phrase.put({within ? GliderLexer::EXIT : GliderLexer::SURFACES, first.begin, first.begin});
  for (size_t k = 0; k <= time; ++k) {
    phrase.put(phrase.token(k));
  }
  return time + 2;
}

/// `require reach back within 13 h`: `reach` alone is about what can be, at any time.
size_t reachWithin(Phrase& phrase) {
  if (phrase.type() != GliderLexer::REACH || !isAnyName(phrase.type(1)) ||
      phrase.type(2) != kWithin) {
    return 0;
  }
  const Lexeme word = phrase.token();
  expected(phrase, word, "`visit`")
      .hint(fmt::format("write `require visit {} {}`", phrase.text(1),
                        phrase.wholeText(2, 1 + tokensOfQuantity(phrase, 3))))
      .fix(phrase.source().range(word), "visit");
  phrase.put({GliderLexer::VISIT, word.begin, word.end});
  return 1;
}

/// `require always hold within 8 h`.
size_t alwaysForVisit(Phrase& phrase) {
  const bool visit = phrase.type() == GliderLexer::ALWAYS && isAnyName(phrase.type(1)) &&
                     phrase.type(2) == GliderLexer::WITHIN && tokensOfQuantity(phrase, 3) > 0 &&
                     phrase.startsLine(3 + tokensOfQuantity(phrase, 3));
  if (!visit || !isStateName(phrase.source(), phrase.text(1))) {
    return 0;
  }
  const Lexeme word = phrase.token();
  expected(phrase, word, "`visit`")
      .hint(fmt::format(
          "write `require visit {} within {}`, or with `or exit` if the mission may end "
          "before",
          phrase.text(1), phrase.wholeText(3, tokensOfQuantity(phrase, 3))));
  phrase.put({GliderLexer::VISIT, word.begin, word.end});
  return 1;
}

/// `require sample at most twice`.
size_t visitLeftOut(Phrase& phrase) {
  const bool count = phrase.type(1) == GliderLexer::AT &&
                     oneOf(phrase.type(2), {GliderLexer::MOST, GliderLexer::LEAST});
  if (!count || !isAnyName(phrase.type()) || !isStateName(phrase.source(), phrase.text())) {
    return 0;
  }
  const Lexeme name = phrase.token();
  expected(phrase, name, "`visit`")
      .hint(fmt::format("write `require visit {} at {} …`", phrase.text(), phrase.text(2)))
      .fix({phrase.source().file, name.begin, name.begin}, "visit ");
  phrase.put({GliderLexer::VISIT, name.begin, name.begin});
  phrase.put(name);
  return 1;
}

/// `require exits within 5 h`, `require exit in 5 h`.
size_t promiseWords(Phrase& phrase) {
  const auto* slip = std::ranges::find_if(kSlips, [&](const Slip& one) {
    return phrase.says(0, one.word) && phrase.says(1, one.next);
  });
  if (slip == std::end(kSlips)) {
    return 0;
  }
  const Lexeme word = phrase.token();
  const Lexeme next = phrase.token(1);
  if (slip->next == slip->meant_next) {
    phrase.reporter()
        .at(word, support::diagnostics::misspelledKeyword, phrase.text(), slip->meant)
        .fix(phrase.source().range(word), std::string(slip->meant));
  } else if (tokensOfQuantity(phrase, 2) > 0) {
    const std::string better = fmt::format("{} {}", slip->meant, slip->meant_next);
    expected(phrase, next, fmt::format("`{}`", slip->meant_next))
        .hint(fmt::format("write `require {} {}`", better,
                          phrase.wholeText(2, tokensOfQuantity(phrase, 2))))
        .fix({phrase.source().file, word.begin, next.end}, better);
  } else {
    return 0;
  }
  phrase.put({slip->type, word.begin, word.end});
  phrase.put({slip->next_type, next.begin, next.end});
  return 2;
}

}  // namespace

size_t promise(Phrase& phrase) {
  if (phrase.before() != GliderLexer::REQUIRE) {
    return 0;
  }
  return firstOf(phrase, {subject, visits, visitLeftOut, timeFirst, reachWithin, neverMoreTimes,
                          neverEnters, eventually, scopeWithoutColon, scopeAtEnd, limitInWords,
                          alwaysForVisit, promiseWords, surfacingAtLeast, surfacesTimes, timeAlone,
                          caseAsWhenever, alwaysAtEnd, alwaysLeftOut});
}

size_t promiseInside(Phrase& phrase) {
  const bool word = oneOf(phrase.type(1), {GliderLexer::NEVER, GliderLexer::ALWAYS});
  if (phrase.before() != GliderLexer::REQUIRE || !word || !isName(phrase.type()) ||
      phrase.startsLine(1)) {
    return 0;
  }
  const Lexeme name = phrase.token();
  const Lexeme keyword = phrase.token(1);
  const std::string said(phrase.text(1));
  expected(phrase, keyword, "an operator")
      .hint(fmt::format("write `require {} {} …`", said, phrase.text()))
      .fix({phrase.source().file, name.begin, keyword.end},
           fmt::format("{} {}", said, phrase.text()));
  phrase.put({keyword.type, keyword.begin, keyword.end});
  phrase.put(name);
  return 2;
}

namespace {

/// `whenever a then b in 5 min`, `visit b in 2 h or exit`.
size_t timeAfterIn(Phrase& phrase) {
  const size_t time = phrase.type() == GliderLexer::IN ? tokensOfQuantity(phrase, 1) : 0;
  const bool ends = phrase.startsLine(1 + time) || phrase.type(1 + time) == GliderLexer::OR_WORD;
  if (time == 0 || !endsValue(phrase.before()) || !ends ||
      !phrase.hasRead({GliderLexer::THEN, GliderLexer::VISIT, GliderLexer::UNTIL})) {
    return 0;
  }
  const Lexeme found = phrase.token();
  expected(phrase, found, "`within`")
      .hint(fmt::format("write `within {}`", phrase.wholeText(1, time)))
      .fix(phrase.source().range(found), "within");
  phrase.put({GliderLexer::WITHIN, found.begin, found.end});
  return 1;
}

/// `whenever a then goto b`, `whenever a goto b`, `whenever a then b 5 min`.
size_t stateOfReaction(Phrase& phrase) {
  const bool transition = oneOf(phrase.type(), {GliderLexer::GOTO, GliderLexer::CALL});
  const bool after_then = phrase.type() == GliderLexer::NUMBER && isAnyName(phrase.before()) &&
                          phrase.before(1) == GliderLexer::THEN;
  if (!transition && !after_then) {
    return 0;
  }
  const Lexeme found = phrase.token();
  if (transition && isAnyName(phrase.type(1)) && phrase.before() == GliderLexer::THEN) {
    phrase.reporter()
        .at(found, support::diagnostics::superfluousWord, phrase.text(), "after `then`")
        .hint(fmt::format("write `then {}`", phrase.text(1)))
        .fix({phrase.source().file, found.begin, phrase.token(1).begin}, "");
    return 1;
  }
  if (transition && isAnyName(phrase.type(1)) && endsValue(phrase.before())) {
    expected(phrase, found, "`then`")
        .hint(fmt::format("write `then {}`", phrase.text(1)))
        .fix(phrase.source().range(found), "then");
    phrase.put({GliderLexer::THEN, found.begin, found.end});
    return 1;
  }
  const size_t number = after_then ? tokensOfQuantity(phrase, 0) : 0;
  if (number == 0) {
    return 0;
  }
  // No fix: how long it takes, or how long it lasts.
  expected(phrase, found, "`within`")
      .hint(fmt::format("write `within {0}`, or `for {0}` if it must stay so for that time",
                        phrase.wholeText(0, number)));
  phrase.insert(GliderLexer::WITHIN);
  phrase.put(found);
  return 1;
}

}  // namespace

namespace {

/// `whenever a, b within 5 min`.
size_t commaOfReaction(Phrase& phrase) {
  if (phrase.type() != GliderLexer::COMMA || !phrase.open().empty() ||
      phrase.hasRead({GliderLexer::THEN}) || !isAnyName(phrase.type(1)) ||
      !oneOf(phrase.type(2), {GliderLexer::WITHIN, GliderLexer::FOR})) {
    return 0;
  }
  const Lexeme comma = phrase.token();
  expected(phrase, comma, "`then`")
      .hint(fmt::format("write `then {}`", phrase.text(1)))
      .fix(phrase.source().range(comma), " then");
  phrase.put({GliderLexer::THEN, comma.begin, comma.end});
  return 1;
}

/// `when look then stay for 2 h`: what stays so is the state itself.
size_t stayInReaction(Phrase& phrase) {
  if (phrase.type() != GliderLexer::STAY || phrase.before() != GliderLexer::THEN) {
    return 0;
  }
  const Lexeme word = phrase.token();
  const bool state = isAnyName(phrase.before(1)) &&
                     oneOf(phrase.before(2), {GliderLexer::WHEN, GliderLexer::WHENEVER});
  const std::string_view name =
      state ? phrase.source().text(*phrase.lexemeBefore(1)) : std::string_view("STATE");
  expected(phrase, word, "a state or a condition")
      .hint(fmt::format("write `then {} …`: what follows `then` is what must be so", name));
  phrase.put({GliderLexer::TRUE, word.begin, word.end});
  phrase.notAsMeant();
  return 1;
}

/// `whenever a then b immediately`.
size_t atOnce(Phrase& phrase) {
  const bool word = phrase.says(0, "immediately") || phrase.says(0, "instantly") ||
                    phrase.says(0, "soon") || phrase.says(0, "eventually");
  if (!word || phrase.startsLine() || !phrase.startsLine(1) || !endsValue(phrase.before()) ||
      !phrase.hasRead({GliderLexer::THEN})) {
    return 0;
  }
  expected(phrase, phrase.token(), "`within`")
      .hint("write the longest time that it may take, as in `within 1 min`");
  return 1;
}

/// `visit state back`, `then state back`: a promise names a state alone.
size_t stateInPromise(Phrase& phrase) {
  const bool named = phrase.type() == GliderLexer::STATE && !phrase.startsLine() &&
                     isAnyName(phrase.type(1)) && !phrase.startsLine(1) &&
                     isStateName(phrase.source(), phrase.text(1));
  // After these, no state is declared.
  const bool wanted =
      oneOf(phrase.before(),
            {GliderLexer::VISIT, GliderLexer::PATROL, GliderLexer::NEVER, GliderLexer::WHEN,
             GliderLexer::WHENEVER, GliderLexer::REACH, GliderLexer::HOLD, GliderLexer::THEN,
             GliderLexer::UNTIL, GliderLexer::IN, GliderLexer::OUTSIDE, GliderLexer::COMMA});
  if (!named || !wanted) {
    return 0;
  }
  phrase.reporter()
      .at(phrase.token(), support::diagnostics::superfluousWord, phrase.text(),
          fmt::format("after `{}`", phrase.source().text(*phrase.lexemeBefore())))
      .fix({phrase.source().file, phrase.token().begin, phrase.token(1).begin}, "");
  return 1;
}

}  // namespace

size_t reaction(Phrase& phrase) {
  // Of a state, `when` is a part of `sample`.
  const bool in_state =
      phrase.hasRead({GliderLexer::BEGIN, GliderLexer::FLIGHTPROFILE, GliderLexer::SENSORS,
                      GliderLexer::SAMPLE, GliderLexer::EVENTS, GliderLexer::CASE});
  if (in_state) {
    return 0;
  }
  if (!phrase.hasRead({GliderLexer::WHENEVER, GliderLexer::WHEN})) {
    return phrase.keyword() == GliderLexer::REQUIRE ? firstOf(phrase, {timeAfterIn, exitAsPlace})
                                                    : 0;
  }
  return firstOf(
      phrase, {timeAfterIn, commaOfReaction, exitAsPlace, stayInReaction, atOnce, stateOfReaction});
}

size_t stateWordInPromise(Phrase& phrase) {
  return phrase.keyword() == GliderLexer::REQUIRE || phrase.before() == GliderLexer::THEN
             ? stateInPromise(phrase)
             : 0;
}

size_t andOfPlaces(Phrase& phrase) {
  const bool both =
      oneOf(phrase.type(), {GliderLexer::AND_WORD, GliderLexer::AND, GliderLexer::ONE_AMPERSAND});
  const bool list =
      oneOf(phrase.before(1), {GliderLexer::VISIT, GliderLexer::PATROL, GliderLexer::COMMA});
  if (!both || phrase.keyword() != GliderLexer::REQUIRE || !list ||
      !phrase.hasRead({GliderLexer::VISIT, GliderLexer::PATROL})) {
    return 0;
  }
  const Lexeme before = *phrase.lexemeBefore();
  const std::string_view first = phrase.source().text(before);
  if (!isStateName(phrase.source(), first) || !isStateName(phrase.source(), phrase.text(1))) {
    return 0;
  }
  const Lexeme word = phrase.token();
  phrase.reporter()
      .at(word, support::diagnostics::missingComma, fmt::format("`{}`", first),
          fmt::format("`{}`", phrase.text(1)))
      .hint(fmt::format("write `{}, {}`", first, phrase.text(1)))
      .fix({phrase.source().file, before.end, word.end}, ",");
  phrase.put({GliderLexer::COMMA, word.begin, word.end});
  return 1;
}

}  // namespace glider::frontend::phrases
