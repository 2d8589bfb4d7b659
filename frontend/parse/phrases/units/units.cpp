// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/units/units.h"

#include "frontend/bare_positions.h"
#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"
#include "frontend/spelling.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace glider::frontend::phrases {
namespace {

bool isDegreeWord(const Phrase& phrase, size_t k) {
  const uint32_t type = phrase.type(k);
  return (type == GliderLexer::FOREIGN && (phrase.text(k) == "°" || phrase.text(k) == "º")) ||
         (type == GliderLexer::UNIT && phrase.text(k) == "deg") ||
         (type == GliderLexer::NAME && unitForWord(phrase.text(k)) == "deg");
}

/// Hours, minutes and seconds as they are written together: the factor to seconds; 0: no such unit.
double secondsOf(std::string_view unit) {
  const std::string_view known = unitForWord(unit);
  return known == "s"               ? 1
         : known == "min"           ? 60
         : known == "h"             ? 3600
         : known.starts_with("day") ? 86400
                                    : 0;
}

/// Part of a time: `3 h`.
struct TimePart {
  bool as_ours = false;  ///< its unit is written as in the language
  double seconds = 0;
  double unit = 0;  ///< in seconds
  size_t tokens = 0;
};

TimePart timePart(const Phrase& phrase, size_t k) {
  if (phrase.type(k) != GliderLexer::NUMBER || !isAnyName(phrase.type(k + 1))) {
    return {};
  }
  const double factor = secondsOf(phrase.text(k + 1));
  return {unitForWord(phrase.text(k + 1)) == phrase.text(k + 1), valueOf(phrase.text(k)) * factor,
          factor, factor > 0 ? 2U : 0U};
}

/// `5400 s` as "1 h 30 min", or in the smallest unit that was written.
std::string timeText(double seconds, double unit) {
  constexpr double kMinute = 60, kHour = 3600;
  const double hours = std::floor(seconds / kHour), rest = seconds - hours * kHour;
  if (unit == kMinute && hours >= 1 && rest > 0) {
    return fmt::format("{:.10g} h {:.10g} min", hours, rest / kMinute);
  }
  return fmt::format("{:.10g} {}", seconds / unit, unit < 60 ? "s" : unit < 3600 ? "min" : "h");
}

void reportTime(Phrase& phrase, size_t tokens, double seconds, double unit) {
  const Lexeme whole = phrase.whole(0, tokens);
  const std::string better = timeText(seconds, unit);
  phrase.reporter()
      .at(whole, support::diagnostics::timeInParts, phrase.source().text(whole), better)
      .fix(phrase.source().range(whole), better);
}

/// `h30`, `h30min` after a number: the digits and the second unit, "30" and "min".
std::optional<std::pair<std::string_view, std::string_view>> gluedTime(std::string_view word) {
  constexpr std::string_view kDigits = "0123456789";
  if (word.size() < 2 || (word[0] != 'h' && word[0] != 'H')) {
    return std::nullopt;
  }
  const size_t end = std::min(word.find_first_not_of(kDigits, 1), word.size());
  const std::string_view rest = word.substr(end);
  const bool minutes = rest.empty() || unitForWord(rest) == "min" || rest == "m";
  return end > 1 && minutes ? std::optional(std::pair(word.substr(1, end - 1), rest))
                            : std::nullopt;
}

/// `1h30`, `1h30min`.
size_t gluedTimeIn(Phrase& phrase) {
  const auto glued = phrase.type(1) == GliderLexer::NAME ? gluedTime(phrase.text(1)) : std::nullopt;
  if (!glued) {
    return 0;
  }
  constexpr double kMinute = 60;
  constexpr double kHour = 3600;
  const Lexeme& word = phrase.token(1);
  reportTime(phrase, 2, valueOf(phrase.text()) * kHour + valueOf(glued->first) * kMinute, kMinute);
  phrase.put(phrase.token());
  phrase.put({GliderLexer::UNIT, word.begin, word.begin + 1});
  return 2;
}

}  // namespace

size_t timeInParts(Phrase& phrase) {
  if (phrase.type() != GliderLexer::NUMBER) {
    return 0;
  }
  if (const size_t taken = gluedTimeIn(phrase)) {
    return taken;
  }
  if (!oneOf(phrase.type(2), {GliderLexer::NUMBER, GliderLexer::AND_WORD})) {
    return 0;  // a number with its unit alone
  }
  const TimePart first = timePart(phrase, 0);
  size_t tokens = first.tokens;
  double seconds = first.seconds;
  double unit = first.unit;
  bool as_ours = first.as_ours;  // `3 h 30 min` is a duration of the language
  while (unit > 0) {
    const bool joined = phrase.type(tokens) == GliderLexer::AND_WORD;
    const TimePart next = timePart(phrase, tokens + (joined ? 1 : 0));
    if (next.tokens == 0 || next.unit >= unit || phrase.startsLine(tokens)) {
      break;
    }
    tokens += next.tokens + (joined ? 1 : 0);
    seconds += next.seconds;
    unit = next.unit;
    as_ours = as_ours && next.as_ours && !joined;
  }
  if (tokens == first.tokens || as_ours) {
    return 0;
  }
  // In a list a comma may be missing between two times.
  const bool list = !phrase.open().empty() && (phrase.open().back().arguments ||
                                               phrase.open().back().type == GliderLexer::LBRACKET);
  if (list) {
    return 0;
  }
  reportTime(phrase, tokens, seconds, unit);
  phrase.put(phrase.token());
  if (first.as_ours) {  // `hours` is reported already
    phrase.put({GliderLexer::UNIT, phrase.token(1).begin, phrase.token(1).end});
  }
  return tokens;
}

size_t degreesCelsius(Phrase& phrase) {
  if (phrase.before() != GliderLexer::NUMBER || !isDegreeWord(phrase, 0) || phrase.startsLine(1)) {
    return 0;
  }
  const std::string scale = phrase.lower(1);
  const bool name = phrase.type(1) == GliderLexer::NAME;
  const bool celsius = name && (scale == "c" || scale == "celsius");
  const bool fahrenheit = name && (scale == "f" || scale == "fahrenheit");
  if (!celsius && !fahrenheit) {
    return 0;
  }
  const Lexeme unit = phrase.whole(0, 2, GliderLexer::UNIT);
  const std::string_view number = phrase.source().text(*phrase.lexemeBefore());
  const bool apart = phrase.lexemeBefore()->end < unit.begin;
  const std::string written(phrase.source().text(unit));
  const bool negative = phrase.before(1) == GliderLexer::MINUS && !endsValue(phrase.before(2));
  const double degrees = negative ? -valueOf(number) : valueOf(number);
  const std::string better = celsius ? "degC" : fmt::format("{:.4g} degC", (degrees - 32) / 1.8);
  auto report = phrase.reporter().at(unit, support::diagnostics::unknownUnit, written,
                                     fmt::format("write `{}`", better));
  if (celsius) {
    report.fix(phrase.source().range(unit), apart ? "degC" : " degC");
    phrase.put(unit);  // AstBuilder reads it as degC
  }
  return 2;
}

namespace {

/// `90 deg mag`, `90 degM`, `90 deg true`.
size_t otherNorth(Phrase& phrase) {
  if (phrase.before() != GliderLexer::NUMBER || phrase.startsLine()) {
    return 0;
  }
  constexpr std::array<std::string_view, 4> kWords = {"mag", "magn", "magnetic", "m"};
  const std::string first = phrase.lower();
  const std::string second = phrase.startsLine(1) ? "" : phrase.lower(1);
  const bool degrees = phrase.type() == GliderLexer::UNIT && first == "deg";
  const bool glued = phrase.type() == GliderLexer::NAME && first.starts_with("deg") &&
                     std::ranges::find(kWords, first.substr(3)) != kWords.end();
  const bool apart = degrees && phrase.text(1) != "magnetic" && phrase.text(1) != "m" &&
                     std::ranges::find(kWords, second) != kWords.end();
  const bool geographic = degrees && (second == "true" || phrase.text(1) == "T");
  const size_t tokens = glued ? 1 : 2;
  if (!(glued || apart || geographic) || phrase.type(tokens) == GliderLexer::LPAREN) {
    return 0;
  }
  if (geographic) {
    phrase.reporter()
        .at(phrase.token(1), support::diagnostics::superfluousWord, phrase.text(1), "after `deg`")
        .hint("delete it: without `magnetic` an angle is from true north")
        .fix({phrase.source().file, phrase.token().end, phrase.token(1).end}, "");
    phrase.put(phrase.token());
    return tokens;
  }
  const Lexeme unit = phrase.whole(0, tokens, GliderLexer::UNIT);
  phrase.reporter()
      .at(unit, support::diagnostics::unknownUnit, phrase.source().text(unit),
          "write `deg magnetic`")
      .fix(phrase.source().range(unit),
           phrase.lexemeBefore()->end < unit.begin ? "deg magnetic" : " deg magnetic");
  phrase.notAsMeant();
  return tokens;
}

}  // namespace

size_t magneticHeading(Phrase& phrase) {
  if (const size_t taken = otherNorth(phrase)) {
    return taken;
  }
  if (phrase.before() != GliderLexer::NUMBER || phrase.type() != GliderLexer::UNIT ||
      phrase.type(1) != GliderLexer::NAME || phrase.text(1) != "magnetic" ||
      phrase.type(2) == GliderLexer::LPAREN) {
    return 0;
  }
  if (phrase.text() != "deg" && phrase.text() != "rad") {
    const std::string value =
        fmt::format("{} {}", phrase.source().text(*phrase.lexemeBefore()), phrase.text());
    phrase.reporter()
        .at(phrase.token(1), support::diagnostics::superfluousWord, "magnetic",
            fmt::format("after `{}`", value))
        .hint("delete it: only an angle is magnetic")
        .fix(phrase.source().range(phrase.token(1)), "");
    phrase.put(phrase.token());
    return 2;
  }
  phrase.put(phrase.whole(0, 2, GliderLexer::UNIT));
  return 2;
}

size_t softUnit(Phrase& phrase) {
  if (phrase.before() != GliderLexer::NUMBER || phrase.type() != GliderLexer::NAME) {
    return 0;
  }
  const bool fraction =
      phrase.type(1) == GliderLexer::DIVIDE && phrase.type(2) == GliderLexer::NAME;
  for (const size_t tokens : {3U, 1U}) {
    if (tokens == 3 && !fraction) {
      continue;
    }
    const std::string written = tokens == 1 ? std::string(phrase.text())
                                            : fmt::format("{}/{}", phrase.text(), phrase.text(2));
    const auto unit = support::findUnit(written);
    if (unit && unit->soft && phrase.type(tokens) != GliderLexer::LPAREN) {
      phrase.put(phrase.whole(0, tokens, GliderLexer::UNIT));
      return tokens;
    }
  }
  return 0;
}

/// `0.5 in)`: `in` begins a range, and a range begins with a value.
size_t rangeWordAsUnit(Phrase& phrase) {
  const uint32_t next = phrase.type(1);
  const bool ends = next == GliderLexer::RPAREN || next == GliderLexer::RBRACKET ||
                    next == GliderLexer::COMMA || next == GliderLexer::RANGE;
  if (phrase.before() != GliderLexer::NUMBER || phrase.type() != GliderLexer::IN || !ends) {
    return 0;
  }
  phrase.reporter()
      .at(phrase.token(), support::diagnostics::unknownUnit, "in",
          "write `inch`: `in` begins a range of values")
      .fix(phrase.source().range(phrase.token()), "inch");
  return 1;
}

}  // namespace glider::frontend::phrases
