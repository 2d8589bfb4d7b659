// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Promises in words that a value stays below or above a limit.

#include "frontend/parse/phrases/comparing.h"
#include "frontend/parse/phrases/promises/parts.h"
#include "frontend/parse/phrases/written_type.h"
#include "frontend/parse/token_kinds.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace glider::frontend::phrases {
namespace {

/// Reports `count` tokens that are to be the promise `always NAME SIGN VALUE`, and puts a condition
/// in their place. Without `certain` the hint has the words of `better`, and nothing is written.
size_t putLimit(Phrase& phrase, size_t count, const std::string& better, bool certain = true) {
  const Lexeme whole = phrase.whole(0, count);
  const bool always = phrase.type() == GliderLexer::ALWAYS;
  auto report = always ? expected(phrase, phrase.token(1), "a condition")
                       : expected(phrase, phrase.token(), "`always` and a condition");
  if (certain) {
    report.hint(fmt::format("write `require {}`", better))
        .fix(phrase.source().range(whole), better);
  } else {
    report.hint(better);
  }
  phrase.put({GliderLexer::ALWAYS, whole.begin, whole.begin});
  phrase.put({GliderLexer::TRUE, whole.begin, whole.end});
  phrase.notAsMeant();
  return count;
}

/// `max depth 60 m`.
size_t greatestOrLeast(Phrase& phrase) {
  const bool most = phrase.says(0, "max") || phrase.says(0, "maximum");
  const bool least = phrase.says(0, "min") || phrase.says(0, "minimum");
  if (!(most || least) || !isName(phrase.type(1))) {
    return 0;
  }
  const bool sign =
      isComparisonSign(phrase.type(2)) || phrase.says(2, "is") || phrase.says(2, "of");
  const size_t value = sign ? 3 : 2;
  const size_t number = tokensOfQuantity(phrase, value);
  if (number == 0) {
    return 0;
  }
  return putLimit(phrase, value + number,
                  fmt::format("always {} {} {}", phrase.text(1),
                              most ? "<=" : ">=", phrase.wholeText(value, number)));
}

/// `the glider never dives below 60 m`.
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
  return putLimit(phrase, first + number,
                  fmt::format("always depth <= {}", phrase.wholeText(first, number)));
}

/// How a promise of a limit begins: `never be`, `always`, `stay`.
struct Opening {
  size_t tokens = 0;  ///< 0: it begins in no such way
  bool never = false;
};

Opening openingOf(const Phrase& phrase) {
  constexpr std::string_view kVerbs[] = {"be", "go", "dive", "get", "stay", "stays", "remain"};
  const auto isVerb = [&](size_t k) {
    return std::ranges::any_of(kVerbs, [&](auto verb) { return phrase.says(k, verb); });
  };
  const bool word = oneOf(phrase.type(), {GliderLexer::NEVER, GliderLexer::ALWAYS});
  const size_t at = word ? 1 : 0;
  return {at + (isVerb(at) ? 1 : 0), phrase.type() == GliderLexer::NEVER};
}

/// `never deeper than 60 m`: the words say which sensor is meant.
size_t comparingReading(Phrase& phrase) {
  struct Comparing {
    std::string_view word;
    std::string_view name;
    bool more;
  };
  constexpr Comparing kComparing[] = {{"deeper", "depth", true},
                                      {"shallower", "depth", false},
                                      {"warmer", "temp", true},
                                      {"colder", "temp", false},
                                      {"cooler", "temp", false}};
  const Opening opening = openingOf(phrase);
  const size_t word = opening.tokens;
  const auto* row = std::ranges::find_if(
      kComparing, [&](const Comparing& one) { return phrase.says(word, one.word); });
  const size_t number = phrase.says(word + 1, "than") ? tokensOfQuantity(phrase, word + 2) : 0;
  if (word == 0 || row == std::end(kComparing) || number == 0) {
    return 0;
  }
  return putLimit(
      phrase, word + 2 + number,
      fmt::format("always {} {} {}", row->name,
                  row->more == opening.never ? "<=" : ">=", phrase.wholeText(word + 2, number)));
}

/// The tokens of `within`, `no more than` from token `k` on, which are about a distance.
size_t tokensOfNearness(const Phrase& phrase, size_t k, bool& near) {
  struct Nearness {
    std::string_view words;
    bool near;
  };
  constexpr Nearness kWords[] = {
      {"within", true},          {"inside", true},          {"less than", true},
      {"closer than", true},     {"nearer than", true},     {"at most", true},
      {"no more than", true},    {"not more than", true},   {"no further than", true},
      {"no farther than", true}, {"beyond", false},         {"outside", false},
      {"more than", false},      {"further than", false},   {"farther than", false},
      {"at least", false},       {"no closer than", false}, {"not less than", false}};
  for (const Nearness& one : kWords) {
    if (const size_t tokens = tokensOfWords(phrase, k, one.words)) {
      near = one.near;
      return tokens;
    }
  }
  return 0;
}

/// `always within 5 km of home`, `never more than 20 km from home`.
size_t distanceFromPlace(Phrase& phrase) {
  const Opening opening = openingOf(phrase);
  bool near = false;
  const size_t words = opening.tokens == 0 ? 0 : tokensOfNearness(phrase, opening.tokens, near);
  const size_t first = opening.tokens + words;
  const size_t number = words == 0 ? 0 : tokensOfQuantity(phrase, first);
  const size_t place = first + number + 1;
  const bool of = oneOf(phrase.type(place - 1), {GliderLexer::OF, GliderLexer::FROM}) ||
                  phrase.says(place - 1, "to");
  if (number == 0 || !of || !isAnyName(phrase.type(place)) || !phrase.startsLine(place + 1)) {
    return 0;
  }
  return putLimit(
      phrase, place + 1,
      fmt::format("always distance({}) {} {}", phrase.text(place),
                  near != opening.never ? "<=" : ">=", phrase.wholeText(first, number)));
}

/// What to write where it is not said what is above a limit: `above 60 m` may be about the depth
/// or about the height above the bottom.
std::string valueToCompare(std::string_view unit, std::string_view value, bool never, bool above) {
  if (never) {
    return fmt::format("write the value that is compared, as in `require never depth > {}`", value);
  }
  if (unit == "m") {
    return above ? fmt::format(
                       "write `require always depth <= {0}`, or `require always altitude >= "
                       "{0}` for the height above the bottom",
                       value)
                 : fmt::format(
                       "write the value that is compared: `require always depth >= {0}` "
                       "stays deeper, `depth <= {0}` shallower",
                       value);
  }
  return fmt::format("write the value that is compared, as in `require always {} {} {}`",
                     unit == "V"      ? "battery"
                     : unit == "degC" ? "temp"
                                      : "…",
                     above ? ">=" : "<=", value);
}

/// `never below 60 m`, `always above 60 m`: what is there is not said.
size_t limitOfNothing(Phrase& phrase) {
  constexpr std::string_view kWords[] = {"below", "above", "under", "over", "exceed", "exceeds"};
  const Opening opening = openingOf(phrase);
  const size_t at = opening.tokens;
  const bool word =
      std::ranges::any_of(kWords, [&](std::string_view one) { return phrase.says(at, one); });
  const bool than = phrase.says(at + 1, "than") && isAnyName(phrase.type(at));
  const size_t first = at + (word ? 1 : 2);
  const size_t number = at > 0 && (word || than) ? tokensOfQuantity(phrase, first) : 0;
  if (number == 0 || !oneOf(phrase.type(), {GliderLexer::NEVER, GliderLexer::ALWAYS})) {
    return 0;
  }
  const bool above = !phrase.says(at, "below") && !phrase.says(at, "under") &&
                     !phrase.says(at, "less") && !phrase.says(at, "lower");
  const Lexeme keyword = phrase.token();
  expected(phrase, phrase.token(at), "a value")
      .hint(valueToCompare(phrase.text(first + number - 1), phrase.wholeText(first, number),
                           opening.never, above));
  phrase.put(keyword);
  phrase.put(phrase.whole(1, first + number - 1, GliderLexer::TRUE));
  phrase.notAsMeant();
  return first + number;
}

/// `depth no more than 60 m`, `depth must be below 60 m`.
size_t readingInWords(Phrase& phrase) {
  // `surfaces at most 4 h` is about the time between two of them.
  const bool name = phrase.type() == GliderLexer::NAME && !phrase.says(0, "surface") &&
                    !phrase.says(0, "exits") && !phrase.says(0, "ends");
  const ComparingPhrase words = name ? comparingAt(phrase, 1) : ComparingPhrase{};
  const size_t first = 1 + words.tokens;
  const size_t number = words.tokens == 0 ? 0 : tokensOfQuantity(phrase, first);
  if (number == 0 || words.changes || phrase.startsLine(1) || !phrase.startsLine(first + number)) {
    return 0;
  }
  return isStateName(phrase.source(), phrase.text())
             ? 0
             : putLimit(phrase, first + number,
                        fmt::format("always {} {} {}", phrase.text(), words.sign,
                                    phrase.wholeText(first, number)));
}

/// The tokens of `energy`, `the mission uses` from token `k` on.
size_t tokensOfUse(const Phrase& phrase, size_t k) {
  constexpr std::string_view kWords[] = {"the mission uses",
                                         "the mission takes",
                                         "the glider uses",
                                         "the vehicle uses",
                                         "mission uses",
                                         "uses",
                                         "use",
                                         "takes",
                                         "consumes",
                                         "spends",
                                         "energy used",
                                         "used energy",
                                         "energy use",
                                         "energy",
                                         "energyused",
                                         "consumption"};
  return tokensOfOne(phrase, k, kWords);
}

/// `energy < 40 Wh`, `uses at most 40 Wh`, `at most 40 Wh`.
size_t limitOfEnergy(Phrase& phrase) {
  const size_t always = phrase.type() == GliderLexer::ALWAYS ? 1 : 0;
  const size_t use = tokensOfUse(phrase, always);
  const size_t at = always + use;
  const bool sign = oneOf(phrase.type(at), {GliderLexer::LT, GliderLexer::LE});
  const ComparingPhrase words = sign ? ComparingPhrase{} : comparingAt(phrase, at);
  const size_t first = at + (sign ? 1 : words.tokens);
  const std::string_view less = sign ? phrase.text(at) : std::string_view(words.sign);
  const size_t number = first == at ? 0 : tokensOfQuantity(phrase, first);
  const bool energy = number == 2 && typeOfUnit(phrase.text(first + 1)) == "energy";
  // One name may be the mission's own: after `always` it is read as a condition.
  const bool right =
      sign && use == 1 &&
      (always == 1 || phrase.says(0, "energyused") || phrase.isDeclared(phrase.text()));
  if (!energy || right || (use == 0 && sign) || (less != "<" && less != "<=") ||
      !phrase.startsLine(first + number)) {
    return 0;
  }
  return putLimit(phrase, first + number,
                  fmt::format("always energyused {} {}", less, phrase.wholeText(first, number)));
}

/// `stay inside [39 N 74 W, …]`.
size_t insidePath(Phrase& phrase) {
  const Opening opening = openingOf(phrase);
  const bool outside = phrase.says(opening.tokens, "outside");
  const size_t list = opening.tokens + 1;
  if (opening.tokens == 0 || !(outside || phrase.says(opening.tokens, "inside")) ||
      phrase.type(list) != GliderLexer::LBRACKET) {
    return 0;
  }
  const size_t line = phrase.tokensOfLine();
  // An array may have that name: `outside[1]`.
  if (phrase.type(line - 1) != GliderLexer::RBRACKET ||
      phrase.wholeText(list, line - list).find(',') == std::string_view::npos) {
    return 0;
  }
  return putLimit(phrase, line,
                  fmt::format("always {}inside({})", outside != opening.never ? "!" : "",
                              phrase.wholeText(list, line - list)));
}

}  // namespace

size_t limitInWords(Phrase& phrase) {
  return firstOf(phrase, {limitOfEnergy, neverDivesBelow, comparingReading, distanceFromPlace,
                          insidePath, limitOfNothing, greatestOrLeast, readingInWords});
}

}  // namespace glider::frontend::phrases
