// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/bare_positions.h"
#include "frontend/parse/phrases/samples/sample_parts.h"
#include "frontend/parse/phrases/written_type.h"
#include "frontend/parse/token_kinds.h"
#include "frontend/spelling.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

// How often an instrument reads: `every TIME` and `one yo in NUMBER`.

namespace glider::frontend::phrases {
namespace {

/// The tokens of a time from token `k` on, also with a unit in words: `4 seconds`.
size_t tokensOfTime(const Phrase& phrase, size_t k) {
  const size_t tokens = tokensOfQuantity(phrase, k);
  if (tokens > 1) {
    return typeOfUnit(phrase.text(k + 1)) == "time" ? tokens : 0;
  }
  const bool word = tokens == 1 && typeOfUnit(unitForWord(phrase.text(k + 1))) == "time" &&
                    !unitForWord(phrase.text(k + 1)).empty();
  return word ? 2 : 0;
}

/// What is written for `every …`: the tokens of all, and of the words before the number.
struct Rate {
  size_t words = 0;
  size_t count = 0;
  double hertz = 0;
  bool certain = true;         ///< its number has a unit
  std::string_view unit = "";  ///< of `each minute`, which has no number
};

Rate rateAt(const Phrase& phrase) {
  Rate rate;
  rate.words = tokensOfOne(phrase, 0,
                           {"once every", "once per", "once in", "once each", "at every",
                            "at a rate of", "on every", "at", "on", "each", "per", "with", "to",
                            "rate", "interval of", "interval", "period of", "period", "every"});
  const bool sign =
      phrase.text() == "@" || oneOf(phrase.type(), {GliderLexer::ASSIGN, GliderLexer::COLON});
  rate.words = sign ? 1 : rate.words;
  rate.words += rate.words > 0 && phrase.type(rate.words) == GliderLexer::ASSIGN ? 1U : 0U;
  const size_t k = rate.words;
  if (phrase.type(k) == GliderLexer::NUMBER && phrase.says(k + 1, "hz")) {
    rate.hertz = valueOf(phrase.text(k));
    rate.count = rate.hertz > 0 ? k + 2 : 0;
  } else if (k > 0 && phrase.type() != GliderLexer::EVERY &&
             typeOfUnit(unitForWord(phrase.text(k))) == "time") {
    rate.count = k + 1;
    rate.unit = unitForWord(phrase.text(k));
  } else if (const size_t time = tokensOfTime(phrase, k);
             time > 0 && phrase.type() != GliderLexer::EVERY) {
    rate.count = k + time;
  } else if (sign && phrase.type(k) == GliderLexer::NUMBER) {
    rate.count = k + 1;  // `= 4`
    rate.certain = false;
  }
  return rate;
}

/// Puts `every …` behind the instrument, where the parts that were read before it leave it room.
void reportEvery(Phrase& phrase, size_t count, const std::string& every) {
  const SampleItem item = sampleItem(phrase);
  const std::string_view parts = readText(phrase, item.when);
  const std::string_view instrument = phrase.source().text(*phrase.lexemeBefore(item.tokens - 1));
  const std::string better = fmt::format("{} {} {}", instrument, every, parts);
  const Lexeme whole{0, phrase.lexemeBefore(item.tokens - 1)->begin, phrase.token(count - 1).end};
  phrase.reporter()
      .at(phrase.whole(0, count), support::diagnostics::headerOrder, phrase.wholeText(0, count),
          fmt::format("before `{}`", parts))
      .hint(fmt::format("write `{}`", better))
      .fix(phrase.source().range(whole), better);
  phrase.notAsMeant();
}

/// `every 0.25 Hz` is so many readings a second.
std::string everyText(const Phrase& phrase, const Rate& rate) {
  if (!rate.unit.empty()) {
    return fmt::format("every 1 {}", rate.unit);
  }
  return rate.hertz > 0
             ? fmt::format("every {:.4g} s", 1 / rate.hertz)
             : fmt::format("every {}", phrase.wholeText(rate.words, rate.count - rate.words));
}

}  // namespace

size_t sampleRate(Phrase& phrase) {
  const SampleItem item = sampleItem(phrase);
  const bool way = oneOf(phrase.before(), {GliderLexer::CLIMBS, GliderLexer::DIVES});
  const bool bare = phrase.type() == GliderLexer::NUMBER;
  if (item.often || !mayBeginPart(phrase) || (bare && !afterInstrument(phrase) && !way)) {
    return 0;
  }
  const Rate rate = rateAt(phrase);
  if (rate.count == 0) {
    return 0;
  }
  const std::string every = everyText(phrase, rate);
  if (item.when > 0) {
    reportEvery(phrase, rate.count, every);
    return rate.count;
  }
  const Lexeme written = phrase.whole(0, rate.count);
  auto report = phrase.reporter().at(written, support::diagnostics::unexpectedToken, "`every`",
                                     fmt::format("`{}`", phrase.source().text(written)));
  report.hint(fmt::format("write `{} {}{}`", phrase.source().text(*phrase.lexemeBefore()), every,
                          rate.certain ? "" : " s"));
  if (rate.certain) {
    report.fix(phrase.source().range(written), every);
  }
  phrase.put({GliderLexer::EVERY, written.begin, written.begin});
  if (rate.hertz > 0 || !rate.unit.empty()) {
    phrase.put({GliderLexer::NUMBER, written.begin, written.end});
    phrase.notAsMeant();
    return rate.count;
  }
  for (size_t k = rate.words; k < rate.count; ++k) {
    phrase.put(phrase.token(k));
  }
  return rate.count;
}

size_t partOrder(Phrase& phrase) {
  const SampleItem item = sampleItem(phrase);
  const bool off = phrase.says(0, "off");
  if (item.often || item.when == 0 || !mayBeginPart(phrase) ||
      (!off && phrase.type() != GliderLexer::EVERY)) {
    return 0;
  }
  const size_t time = off ? 0 : tokensOfQuantity(phrase, 1);
  const size_t value = time == 0 && isName(phrase.type(1)) ? 1 : time;
  if (!off && value == 0) {
    return 0;
  }
  const std::string every(phrase.wholeText(0, 1 + value));
  reportEvery(phrase, 1 + value, every);
  return 1 + value;
}

namespace {

constexpr std::array<std::string_view, 13> kOrdinals = {
    "zeroth",  "first",  "second", "third", "fourth",   "fifth",  "sixth",
    "seventh", "eighth", "ninth",  "tenth", "eleventh", "twelfth"};

/// A count, with the tokens that it takes.
struct Count {
  size_t tokens = 0;
  std::string digits;
};

/// `3`, `three`, `3rd`, `third`, `other`.
Count countAt(const Phrase& phrase, size_t k) {
  if (phrase.type(k) == GliderLexer::NUMBER) {
    const bool ending =
        phrase.touches(k + 1) && tokensOfOne(phrase, k + 1, {"st", "nd", "rd", "th"}) > 0;
    return {ending ? size_t{2} : size_t{1}, std::string(phrase.text(k))};
  }
  const std::string word = phrase.lower(k);
  const auto* number = std::ranges::find(kNumberWords, word);
  const auto* ordinal = std::ranges::find(kOrdinals, word);
  if (word == "other") {
    return {1, "2"};
  }
  return number != kNumberWords.end() ? Count{1, std::to_string(number - kNumberWords.begin())}
         : ordinal != kOrdinals.end() ? Count{1, std::to_string(ordinal - kOrdinals.begin())}
                                      : Count{};
}

size_t yoWord(const Phrase& phrase, size_t k) {
  if (phrase.type(k) == GliderLexer::YO) {
    return 1;
  }
  return tokensOfOne(phrase, k, {"yo", "yos"});
}

/// `every third yo`, `every yo`: the tokens, and how many yos; one for each.
Count everyYo(const Phrase& phrase) {
  const size_t on = tokensOfOne(phrase, 0, {"on every", "on each", "every", "each"});
  if (on == 0) {
    return {};
  }
  if (const size_t yo = yoWord(phrase, on)) {
    return {on + yo, "1"};
  }
  Count count = countAt(phrase, on);
  const size_t yo = count.tokens == 0 ? 0 : yoWord(phrase, on + count.tokens);
  count.tokens = yo == 0 ? 0 : on + count.tokens + yo;
  return count;
}

/// `one in 3`, `1 yo of 3`, `one yo in 3 yos`, `in 1 yo of 3`; none if it is right.
Count oneYo(const Phrase& phrase) {
  const size_t in = phrase.says(0, "in") ? 1 : 0;
  const bool one = phrase.says(in, "one") || phrase.text(in) == "1";
  if (!one) {
    return {};
  }
  const size_t yo = yoWord(phrase, in + 1);
  const size_t of =
      tokensOfOne(phrase, in + 1 + yo, {"in every", "out of", "in", "of", "per", "every"});
  Count count = of == 0 ? Count{} : countAt(phrase, in + 1 + yo + of);
  if (count.tokens == 0) {
    return {};
  }
  const size_t number = in + 1 + yo + of;
  const size_t end = number + count.tokens + yoWord(phrase, number + count.tokens);
  const bool right = in == 0 && phrase.text() == "one" && phrase.text(1) == "yo" &&
                     phrase.text(2) == "in" && of == 1 &&
                     phrase.type(number) == GliderLexer::NUMBER && end == number + 1;
  count.tokens = right || (yo == 0 && end == number + 1 && phrase.text(in) == "1") ? 0 : end;
  return count;
}

/// `one dive in 3`, `every second dive`: how many, with the way that is meant.
struct SomeWay {
  Count count;
  bool dives = false;
};

SomeWay someWay(const Phrase& phrase) {
  const auto way = [&](size_t k, bool& dives) {
    dives = tokensOfOne(phrase, k, {"dive", "dives", "downcast", "descent"}) > 0;
    return dives || tokensOfOne(phrase, k, {"climb", "climbs", "upcast", "ascent"}) > 0;
  };
  SomeWay some;
  const size_t every = tokensOfOne(phrase, 0, {"on every", "on each", "every", "each"});
  const size_t one = tokensOfOne(phrase, 0, {"one"});
  if (every > 0) {
    some.count = countAt(phrase, every);
    some.count.tokens += every;
    const bool right = some.count.tokens > every && way(some.count.tokens, some.dives);
    some.count.tokens = right ? some.count.tokens + 1 : 0;
  } else if (one > 0 && way(1, some.dives)) {
    const size_t of = tokensOfOne(phrase, 2, {"out of", "in", "of"});
    some.count = of == 0 ? Count{} : countAt(phrase, 2 + of);
    some.count.tokens += some.count.tokens == 0 ? 0 : 2 + of;
  }
  return some;
}

size_t oneWayIn(Phrase& phrase) {
  const SomeWay some = someWay(phrase);
  if (some.count.tokens == 0) {
    return 0;
  }
  reportMeant(
      phrase, some.count.tokens,
      fmt::format("on {} one yo in {}", some.dives ? "dives" : "climbs", some.count.digits));
  const Lexeme written = phrase.whole(0, some.count.tokens);
  phrase.put({GliderLexer::ON, written.begin, written.end});
  phrase.put({some.dives ? uint32_t{GliderLexer::DIVES} : uint32_t{GliderLexer::CLIMBS},
              written.begin, written.end});
  return some.count.tokens;
}

}  // namespace

size_t someYos(Phrase& phrase) {
  if (!mayBeginPart(phrase)) {
    return 0;
  }
  if (const size_t taken = oneWayIn(phrase)) {
    return taken;
  }
  const Count every = everyYo(phrase);
  const Count count = every.tokens > 0 ? every : oneYo(phrase);
  if (count.tokens == 0) {
    return 0;
  }
  if (count.digits == "1") {
    return leaveOutWords(
        phrase, count.tokens,
        "after an instrument: it reads on every yo unless `one yo in …` is written");
  }
  reportMeant(phrase, count.tokens, fmt::format("one yo in {}", count.digits));
  const Lexeme written = phrase.whole(0, count.tokens);
  for (const uint32_t type :
       {GliderLexer::ONE, GliderLexer::YO, GliderLexer::IN, GliderLexer::NUMBER}) {
    phrase.put({type, written.begin, written.end});
  }
  phrase.notAsMeant();
  return count.tokens;
}

}  // namespace glider::frontend::phrases
