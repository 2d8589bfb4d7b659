// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/choices/clauses.h"
#include "frontend/parse/phrases/samples/sample_parts.h"
#include "frontend/parse/phrases/written_type.h"
#include "frontend/parse/token_kinds.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

// Where an instrument reads: on climbs or dives, at some depths, under a condition.

namespace glider::frontend::phrases {
namespace {

/// The words for one way of the vehicle, with what stands around them.
struct Way {
  size_t tokens = 0;
  uint32_t type = 0;  ///< `climbs` or `dives`
};

Way wordOfWay(const Phrase& phrase, size_t k) {
  if (const size_t tokens =
          tokensOfOne(phrase, k,
                      {"climbs", "climb", "climbing", "ascents", "ascent", "ascending", "upcasts",
                       "upcast", "upwards", "up", "way up", "rising"})) {
    return {tokens, GliderLexer::CLIMBS};
  }
  const size_t tokens =
      tokensOfOne(phrase, k,
                  {"dives", "dive", "diving", "descents", "descent", "descending", "downcasts",
                   "downcast", "downwards", "down", "way down", "sinking"});
  return {tokens, tokens > 0 ? uint32_t{GliderLexer::DIVES} : 0};
}

/// `only on the climb`, `while climbing`, `climbs`.
Way wayAt(const Phrase& phrase, size_t k) {
  size_t lead = tokensOfOne(phrase, k, {"only"});
  lead += tokensOfOne(phrase, k + lead,
                      {"when on", "on", "while", "during", "in", "at", "for", "when", "if"});
  lead += tokensOfOne(phrase, k + lead, {"only"});
  lead += tokensOfOne(phrase, k + lead, {"the", "each", "every", "all"});
  const Way way = wordOfWay(phrase, k + lead);
  if (phrase.says(k + lead + way.tokens, "to")) {
    return {};  // `down to 20 m`
  }
  const size_t only = way.tokens == 0 ? 0 : tokensOfOne(phrase, k + lead + way.tokens, {"only"});
  return {way.tokens == 0 ? 0 : lead + way.tokens + only, way.type};
}

/// The tokens of `and climbs`, `or on climbs` from token `k` on, after the other way.
size_t otherWay(const Phrase& phrase, size_t k, const Way& first) {
  const bool joined = oneOf(phrase.type(k), {GliderLexer::AND_WORD, GliderLexer::OR_WORD,
                                             GliderLexer::AND, GliderLexer::OR, GliderLexer::PLUS,
                                             GliderLexer::ONE_AMPERSAND, GliderLexer::DIVIDE}) ||
                      phrase.says(k, "and") || phrase.says(k, "or");
  const Way second = joined ? wayAt(phrase, k + 1) : Way{};
  return second.tokens > 0 && second.type != first.type ? second.tokens + 1 : 0;
}

std::string_view wayText(uint32_t type) {
  return type == GliderLexer::CLIMBS ? "on climbs" : "on dives";
}

/// `when climbing`, `when down > 3`: a condition of the language.
bool isCondition(Phrase& phrase, const Way& way) {
  return phrase.type() == GliderLexer::WHEN &&
         (phrase.says(1, "climbing") || phrase.says(1, "diving") ||
          isOperator(phrase.type(way.tokens)) || phrase.isDeclared(phrase.text(1)));
}

}  // namespace

size_t wayOfVehicle(Phrase& phrase) {
  const Way way =
      mayBeginPart(phrase) && phrase.before() != GliderLexer::NUMBER ? wayAt(phrase, 0) : Way{};
  if (way.tokens == 0 || isCondition(phrase, way)) {
    return 0;
  }
  if (const size_t other = otherWay(phrase, way.tokens, way)) {
    return leaveOutWords(phrase, way.tokens + other,
                         "after an instrument: it reads on both unless one of them is named");
  }
  const std::string_view better = wayText(way.type);
  if (way.tokens != 2 || phrase.text() != "on" || phrase.text(1) != better.substr(3)) {
    reportMeant(phrase, way.tokens, better);
  }
  const Lexeme written = phrase.whole(0, way.tokens);
  phrase.put({GliderLexer::ON, written.begin, written.end});
  phrase.put({way.type, written.begin, written.end});
  return way.tokens;
}

namespace {

/// `deeper than`, `>`: the tokens, and whether it is below what follows.
struct Side {
  size_t tokens = 0;
  bool below = false;
};

Side sideAt(const Phrase& phrase) {
  const size_t lead =
      tokensOfOne(phrase, 0, {"only when", "only if", "only", "when", "if", "at depths"});
  const auto side = [&](size_t tokens, bool below) { return Side{lead + tokens, below}; };
  if (const size_t tokens =
          tokensOfOne(phrase, lead,
                      {"deeper than", "lower than", "under", "beneath", "underneath", "beyond"})) {
    return side(tokens, true);
  }
  if (const size_t tokens =
          tokensOfOne(phrase, lead, {"shallower than", "higher than", "down to"})) {
    return side(tokens, false);
  }
  const bool sign = afterInstrument(phrase) && lead == 0;
  if (sign && oneOf(phrase.type(), {GliderLexer::GT, GliderLexer::GE})) {
    return {1, true};
  }
  if (sign && oneOf(phrase.type(), {GliderLexer::LT, GliderLexer::LE})) {
    return {1, false};
  }
  // `only below 10 m`: the word alone is right.
  const bool below = phrase.says(lead, "below");
  return lead > 0 && (below || phrase.says(lead, "above")) ? side(1, below) : Side{};
}

/// The tokens of a depth from token `k` on.
size_t tokensOfDepth(const Phrase& phrase, size_t k) {
  const size_t tokens = tokensOfQuantity(phrase, k);
  return tokens == 0 && phrase.type(k) == GliderLexer::NAME ? 1 : tokens;
}

size_t oneSide(Phrase& phrase) {
  if (phrase.type() == GliderLexer::WHEN && phrase.isDeclared(phrase.text(1))) {
    return 0;
  }
  const Side side = sideAt(phrase);
  const size_t depth = side.tokens == 0 ? 0 : tokensOfDepth(phrase, side.tokens);
  if (depth == 0) {
    return 0;
  }
  reportMeant(
      phrase, side.tokens + depth,
      fmt::format("{} {}", side.below ? "below" : "above", phrase.wholeText(side.tokens, depth)));
  const Lexeme words = phrase.whole(0, side.tokens);
  phrase.put({side.below ? uint32_t{GliderLexer::BELOW} : uint32_t{GliderLexer::ABOVE}, words.begin,
              words.end});
  for (size_t k = side.tokens; k < side.tokens + depth; ++k) {
    phrase.put(phrase.token(k));
  }
  return side.tokens + depth;
}

/// Whether tokens `first` to `end` are a depth: `10 m`, `10`.
bool isDepth(const Phrase& phrase, size_t first, size_t end) {
  const std::string_view type = typeOf(phrase, first);
  return tokensOfQuantity(phrase, first) == end - first && (type == "length" || type == "number");
}

/// `between 10 m and 20 m`, `from 10 m to 20 m`, `10 m .. 20 m`.
size_t layer(Phrase& phrase) {
  const size_t lead =
      tokensOfOne(phrase, 0, {"only between", "only from", "between", "from", "in"});
  const bool bare = afterInstrument(phrase) && phrase.type() == GliderLexer::NUMBER;
  if (lead == 0 && !bare) {
    return 0;
  }
  const size_t end = endOfValue(phrase, lead, true);
  const auto ends = endsOf(phrase, lead, end);
  if (!ends || !isDepth(phrase, ends->low, ends->low_end) ||
      !isDepth(phrase, ends->high, ends->high_end)) {
    return 0;
  }
  const size_t unit = ends->sharedUnit(phrase);
  const std::string low =
      fmt::format("{}{}", phrase.wholeText(ends->low, ends->low_end - ends->low),
                  unit == 0 ? "" : fmt::format(" {}", phrase.text(unit)));
  const std::string better = fmt::format("below {} above {}", low,
                                         phrase.wholeText(ends->high, ends->high_end - ends->high));
  reportMeant(phrase, end, better);
  const Lexeme words = phrase.token();
  phrase.put({GliderLexer::BELOW, words.begin, words.end});
  for (size_t k = ends->low; k < ends->low_end; ++k) {
    phrase.put(phrase.token(k));
  }
  phrase.put({GliderLexer::ABOVE, words.begin, words.end});
  for (size_t k = ends->high; k < ends->high_end; ++k) {
    phrase.put(phrase.token(k));
  }
  return end;
}

}  // namespace

size_t sampleDepth(Phrase& phrase) {
  return mayBeginPart(phrase) ? firstOf(phrase, {layer, oneSide}) : 0;
}

namespace {

/// `for 10 min`, `after 1 h`: what is about the time of the state is a condition.
size_t timeOfState(Phrase& phrase) {
  const size_t on = tokensOfOne(phrase, 0, {"on", "only"});
  const size_t after = tokensOfOne(phrase, on, {"after", "from"});
  const size_t until = tokensOfOne(phrase, on, {"until", "for the first", "for", "before"});
  const size_t words = after + until == 0 ? 0 : on + after + until;
  const size_t time = words == 0 ? 0 : tokensOfQuantity(phrase, words);
  if (time < 2) {
    return 0;
  }
  const Lexeme written = phrase.whole(0, words + time);
  phrase.reporter()
      .at(written, support::diagnostics::unexpectedToken, "`when` and a condition",
          fmt::format("`{}`", phrase.source().text(written)))
      .hint(fmt::format("write for example `when {} {} {}`",
                        typeOf(phrase, words) == "length" ? "depth" : "statetime",
                        after > 0 ? ">" : "<", phrase.wholeText(words, time)));
  phrase.notAsMeant();
  return words + time;
}

/// `at the surface`, `under water`.
size_t surfaceWords(Phrase& phrase) {
  const size_t lead = tokensOfOne(phrase, 0, {"only"});
  const size_t at = tokensOfOne(phrase, lead, {"at the surface", "at surface", "on the surface"});
  const size_t under = tokensOfOne(phrase, lead, {"underwater", "under water", "submerged"});
  if (at + under == 0) {
    return 0;
  }
  const size_t count = lead + at + under;
  reportMeant(phrase, count, at > 0 ? "when at_surface" : "when !at_surface");
  const Lexeme written = phrase.whole(0, count);
  phrase.put({GliderLexer::WHEN, written.begin, written.end});
  phrase.put({GliderLexer::TRUE, written.begin, written.end});
  phrase.notAsMeant();
  return count;
}

/// `off unless depth > 10 m`.
size_t unless(Phrase& phrase) {
  if (!phrase.says(0, "unless") || !startsAnyValue(phrase.type(1))) {
    return 0;
  }
  const Lexeme word = phrase.token();
  phrase.reporter()
      .at(word, support::diagnostics::unexpectedToken, "`when`", describe(phrase.source(), word))
      .hint("write `when !(…)` with the condition in the parentheses");
  phrase.put({GliderLexer::WHEN, word.begin, word.end});
  phrase.notAsMeant();
  return 1;
}

/// `ctd depth > 10 m`.
size_t whenLeftOut(Phrase& phrase) {
  const uint32_t sign = phrase.type(1);
  if (!afterInstrument(phrase) || phrase.type() != GliderLexer::NAME ||
      !(sign >= GliderLexer::EQ && sign <= GliderLexer::GT)) {
    return 0;
  }
  const Lexeme name = phrase.token();
  phrase.reporter()
      .at(name, support::diagnostics::unexpectedToken, "`when`", describe(phrase.source(), name))
      .hint(fmt::format("write `when {} …`", phrase.wholeText(0, 2)))
      .fix({phrase.source().file, name.begin, name.begin}, "when ");
  phrase.put({GliderLexer::WHEN, name.begin, name.begin});
  phrase.put(name);
  return 1;
}

}  // namespace

size_t sampleCondition(Phrase& phrase) {
  if (!mayBeginPart(phrase)) {
    return 0;
  }
  if (const size_t taken = firstOf(phrase, {timeOfState, surfaceWords, unless, whenLeftOut})) {
    return taken;
  }
  const size_t words =
      tokensOfOne(phrase, 0, {"only when", "only if", "only while", "if", "where", "while"});
  if (words == 0 ||
      !(startsAnyValue(phrase.type(words)) || phrase.type(words) == GliderLexer::NOT)) {
    return 0;
  }
  reportMeant(phrase, words, "when");
  const Lexeme written = phrase.whole(0, words);
  phrase.put({GliderLexer::WHEN, written.begin, written.end});
  return words;
}

}  // namespace glider::frontend::phrases
