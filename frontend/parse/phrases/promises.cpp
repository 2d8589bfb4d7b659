// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::frontend::phrases {
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

support::DiagnosticBuilder expected(Phrase& phrase, const Lexeme& found, std::string_view what) {
  return phrase.reporter().at(found, support::diagnostics::unexpectedToken, what,
                              describe(phrase.source(), found));
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

bool isComparison(uint32_t type) {
  return (type >= GliderLexer::EQ && type <= GliderLexer::GT) || type == GliderLexer::ASSIGN;
}

/// `depth below 55 m`, `depth is less than 55 m`: the words are errors of their own.
bool isComparedInWords(const Phrase& phrase) {
  constexpr std::string_view kWords[] = {"below", "above", "under", "over",  "less",
                                         "more",  "at",    "is",    "stays", "greater"};
  return phrase.type() == GliderLexer::NAME && !phrase.startsLine(1) &&
         std::ranges::any_of(kWords, [&](std::string_view word) { return phrase.says(1, word); });
}

/// Whether a word of a promise other than `then` was read since `require`.
bool hasRead(const Phrase& phrase, std::initializer_list<uint32_t> words) {
  constexpr size_t kFarthest = 100;
  for (size_t k = 0; k < kFarthest; ++k) {
    const uint32_t type = phrase.before(k);
    if (std::ranges::find(words, type) != words.end()) {
      return true;
    }
    if (type == 0 || type == GliderLexer::REQUIRE || startsItem(type)) {
      return false;
    }
  }
  return false;
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
    compares = compares || isComparison(type);
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
    compares = compares || isComparison(phrase.type(k));
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

/// Reports `count` tokens that are to be the promise `always NAME SIGN VALUE`, and puts a condition
/// in their place.
void putLimit(Phrase& phrase, size_t count, const std::string& better) {
  const Lexeme whole = phrase.whole(0, count);
  expected(phrase, phrase.token(), "`always` and a condition")
      .hint(fmt::format("write `require {}`", better))
      .fix(phrase.source().range(whole), better);
  phrase.put({GliderLexer::ALWAYS, whole.begin, whole.begin});
  phrase.put({GliderLexer::TRUE, whole.begin, whole.end});
  phrase.notAsMeant();
}

/// `require max depth 60 m`.
size_t greatestOrLeast(Phrase& phrase) {
  const bool most = phrase.says(0, "max") || phrase.says(0, "maximum");
  const bool least = phrase.says(0, "min") || phrase.says(0, "minimum");
  if (!(most || least) || !isName(phrase.type(1))) {
    return 0;
  }
  const bool sign = isComparison(phrase.type(2)) || phrase.says(2, "is") || phrase.says(2, "of");
  const size_t value = sign ? 3 : 2;
  const size_t number = tokensOfQuantity(phrase, value);
  if (number == 0) {
    return 0;
  }
  putLimit(phrase, value + number,
           fmt::format("always {} {} {}", phrase.text(1),
                       most ? "<=" : ">=", phrase.wholeText(value, number)));
  return value + number;
}

/// `require the glider never dives below 60 m`.
size_t neverDivesBelow(Phrase& phrase) {
  const size_t article = phrase.says(0, "the") ? 1 : 0;
  const size_t never = article + (phrase.says(article, "glider") ? 1 : 0);
  const bool verb = phrase.says(never + 1, "dives") || phrase.says(never + 1, "dive") ||
                    phrase.says(never + 1, "goes") || phrase.says(never + 1, "go");
  const size_t than = phrase.says(never + 2, "deeper") && phrase.says(never + 3, "than") ? 1 : 0;
  const size_t first = never + 3 + than;
  const size_t number = tokensOfQuantity(phrase, first);
  if (phrase.type(never) != GliderLexer::NEVER || !verb || number == 0 ||
      !(than == 1 || phrase.says(never + 2, "below"))) {
    return 0;
  }
  putLimit(phrase, first + number,
           fmt::format("always depth <= {}", phrase.wholeText(first, number)));
  return first + number;
}

/// `require never deeper than 60 m`: the words say which sensor is meant.
size_t neverComparing(Phrase& phrase) {
  struct Comparing {
    std::string_view word;
    std::string_view allowed;  ///< what is then always so
  };
  constexpr Comparing kComparing[] = {{"deeper", "depth <="},
                                      {"shallower", "depth >="},
                                      {"warmer", "temp <="},
                                      {"colder", "temp >="},
                                      {"cooler", "temp >="}};
  const bool verb = phrase.says(1, "be") || phrase.says(1, "go") || phrase.says(1, "dive") ||
                    phrase.says(1, "get");
  const size_t word = verb ? 2 : 1;
  const auto* row = std::ranges::find_if(
      kComparing, [&](const Comparing& one) { return phrase.says(word, one.word); });
  const size_t number = phrase.says(word + 1, "than") ? tokensOfQuantity(phrase, word + 2) : 0;
  if (phrase.type() != GliderLexer::NEVER || row == std::end(kComparing) || number == 0) {
    return 0;
  }
  putLimit(phrase, word + 2 + number,
           fmt::format("always {} {}", row->allowed, phrase.wholeText(word + 2, number)));
  return word + 2 + number;
}

/// `require never below 60 m`: what is below it is not said.
size_t neverOfNothing(Phrase& phrase) {
  constexpr std::string_view kWords[] = {"below", "above", "under", "over", "exceed", "exceeds"};
  const bool word =
      std::ranges::any_of(kWords, [&](std::string_view one) { return phrase.says(1, one); });
  const bool than = phrase.says(2, "than") && isAnyName(phrase.type(1));
  const size_t first = word ? 2 : 3;
  const size_t number = word || than ? tokensOfQuantity(phrase, first) : 0;
  if (phrase.type() != GliderLexer::NEVER || number == 0) {
    return 0;
  }
  const Lexeme never = phrase.token();
  expected(phrase, phrase.token(1), "a value")
      .hint(fmt::format("write the value that is compared, as in `require never depth > {}`",
                        phrase.wholeText(first, number)));
  phrase.put(never);
  phrase.put(phrase.whole(1, first + number - 1, GliderLexer::TRUE));
  phrase.notAsMeant();
  return first + number;
}

/// `require exit 13 h`, `require exit <= 13 h`, `require surfaces 4 h`: a number without its word.
size_t timeAlone(Phrase& phrase) {
  const bool exit = phrase.type() == GliderLexer::EXIT;
  const bool sign = oneOf(
      phrase.type(1), {GliderLexer::LE, GliderLexer::LT, GliderLexer::COLON, GliderLexer::ASSIGN});
  const size_t first = sign ? 2 : 1;
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
  phrase.put({exit ? kWithin : kEvery, found.begin, sign ? found.end : found.begin});
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

/// `require within 7 h exit`.
size_t timeBeforeExit(Phrase& phrase) {
  const size_t time = phrase.type() == GliderLexer::WITHIN ? tokensOfQuantity(phrase, 1) : 0;
  if (time == 0 || phrase.type(1 + time) != GliderLexer::EXIT) {
    return 0;
  }
  const Lexeme within = phrase.token();
  const Lexeme whole = phrase.whole(0, time + 2);
  const std::string better = fmt::format("exit {}", phrase.wholeText(0, time + 1));
  expected(phrase, within, "`exit within`")
      .hint(fmt::format("write `require {}`", better))
      .fix(phrase.source().range(whole), better);
  phrase.put({GliderLexer::EXIT, within.begin, within.begin});
  for (size_t k = 0; k <= time; ++k) {
    phrase.put(phrase.token(k));
  }
  return time + 2;
}

/// `require always within 5 km of home`.
size_t alwaysWithinDistance(Phrase& phrase) {
  const bool within = phrase.type() == GliderLexer::ALWAYS && phrase.type(1) == GliderLexer::WITHIN;
  const size_t distance = within ? tokensOfQuantity(phrase, 2) : 0;
  const size_t place = 2 + distance;
  if (distance == 0 || phrase.type(place) != GliderLexer::OF ||
      !isAnyName(phrase.type(place + 1))) {
    return 0;
  }
  const Lexeme written = phrase.whole(1, place + 1, GliderLexer::TRUE);
  const std::string better =
      fmt::format("distance({}) <= {}", phrase.text(place + 1), phrase.wholeText(2, distance));
  expected(phrase, phrase.token(1), "a condition")
      .hint(fmt::format("write `require always {}`", better))
      .fix(phrase.source().range(written), better);
  phrase.put(phrase.token());
  phrase.put(written);
  phrase.notAsMeant();
  return place + 2;
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
  return firstOf(
      phrase, {subject, visits, visitLeftOut, timeBeforeExit, alwaysWithinDistance, alwaysForVisit,
               promiseWords, surfacingAtLeast, timeAlone, caseAsWhenever, alwaysAtEnd,
               neverDivesBelow, neverComparing, neverOfNothing, greatestOrLeast, alwaysLeftOut});
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

/// `whenever a then b in 5 min`.
size_t timeOfReaction(Phrase& phrase) {
  const size_t time = phrase.type() == GliderLexer::IN ? tokensOfQuantity(phrase, 1) : 0;
  if (time == 0 || !endsValue(phrase.before()) || !phrase.startsLine(1 + time) ||
      !hasRead(phrase, {GliderLexer::THEN})) {
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

size_t reaction(Phrase& phrase) {
  return hasRead(phrase, {GliderLexer::WHENEVER, GliderLexer::WHEN})
             ? firstOf(phrase, {timeOfReaction, stateOfReaction})
             : 0;
}

size_t andOfPlaces(Phrase& phrase) {
  const bool both =
      oneOf(phrase.type(), {GliderLexer::AND_WORD, GliderLexer::AND, GliderLexer::ONE_AMPERSAND});
  const bool list =
      oneOf(phrase.before(1), {GliderLexer::VISIT, GliderLexer::PATROL, GliderLexer::COMMA});
  if (!both || phrase.keyword() != GliderLexer::REQUIRE || !list ||
      !hasRead(phrase, {GliderLexer::VISIT, GliderLexer::PATROL})) {
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
