// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>

namespace glider::frontend::phrases {
namespace {

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

/// Reads the characters of a date or a time.
class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  [[nodiscard]] size_t at() const { return at_; }
  [[nodiscard]] char next(size_t k = 0) const {
    return at_ + k < text_.size() ? text_[at_ + k] : '\0';
  }
  bool take(char c) {
    const bool found = next() == c;
    at_ += found ? 1U : 0U;
    return found;
  }
  bool take(std::string_view word) {
    const bool found = text_.substr(at_).starts_with(word);
    at_ += found ? word.size() : 0U;
    return found;
  }
  void skipSpaces() {
    while (take(' ')) {
    }
  }
  /// From `least` to `most` digits, and no more; empty: there are none.
  std::string_view digits(size_t least, size_t most) {
    size_t n = 0;
    while (isDigit(next(n))) {
      ++n;
    }
    if (n < least || n > most) {
      return {};
    }
    at_ += n;
    return text_.substr(at_ - n, n);
  }

 private:
  std::string_view text_;
  size_t at_ = 0;
};

/// `18:30`, `18:30:10`.
struct Clock {
  unsigned hours = 0;
  unsigned minutes = 0;
  unsigned seconds = 0;
  bool three = false;  ///< it has seconds
};

constexpr unsigned kDay_h = 24;

unsigned numberOf(std::string_view digits) {
  unsigned n = 0;
  for (const char c : digits) {
    n = n * 10 + static_cast<unsigned>(c - '0');
  }
  return n;
}

std::optional<Clock> clockAt(Reader& reader) {
  Clock clock;
  const std::string_view hours = reader.digits(1, 2);
  if (hours.empty() || !reader.take(':')) {
    return std::nullopt;
  }
  const std::string_view minutes = reader.digits(2, 2);
  if (minutes.empty()) {
    return std::nullopt;
  }
  clock.hours = numberOf(hours);
  clock.minutes = numberOf(minutes);
  if (reader.next() == ':' && isDigit(reader.next(1))) {
    reader.take(':');
    const std::string_view seconds = reader.digits(2, 2);
    if (seconds.empty()) {
      return std::nullopt;
    }
    clock.seconds = numberOf(seconds);
    clock.three = true;
  }
  constexpr unsigned kSixty = 60;
  const bool valid = clock.minutes < kSixty && clock.seconds < kSixty;
  return valid ? std::optional(clock) : std::nullopt;
}

/// `18 h 30 min`, as the language writes a time of the day; `0 h` only where nothing else is there.
std::string asDuration(const Clock& clock) {
  const bool rest = clock.minutes > 0 || clock.seconds > 0;
  std::string out = clock.hours > 0 || !rest ? fmt::format("{} h ", clock.hours) : "";
  out += clock.minutes > 0 ? fmt::format("{} min ", clock.minutes) : "";
  out += clock.seconds > 0 ? fmt::format("{} s ", clock.seconds) : "";
  out.pop_back();
  return out;
}

/// `18:30` as 18 minutes and 30 seconds.
std::string asMinutes(const Clock& clock) {
  return asDuration({0, clock.hours, clock.minutes});
}

/// A time of the calendar as it was written, and as the language writes it.
struct Written {
  size_t length = 0;
  std::string better;
  bool utc = false;  ///< it says that it is UTC
};

std::optional<Written> instantAt(std::string_view text) {
  Reader reader(text);
  const std::string_view year = reader.digits(4, 4);
  if (year.empty() || !reader.take('-')) {
    return std::nullopt;
  }
  const std::string_view month = reader.digits(2, 2);
  if (month.empty() || !reader.take('-')) {
    return std::nullopt;
  }
  const std::string_view day = reader.digits(2, 2);
  if (day.empty()) {
    return std::nullopt;
  }
  if (!reader.take('T') && !reader.take('t')) {
    reader.skipSpaces();
  }
  const auto clock = clockAt(reader);
  if (!clock || clock->hours > kDay_h) {
    return std::nullopt;  // a date alone is for analysis
  }
  Written written;
  written.length = reader.at();
  reader.skipSpaces();
  written.utc = reader.take("UTC") || reader.take("utc") || reader.take('Z') || reader.take('z');
  written.length = written.utc ? reader.at() : written.length;
  const std::string seconds = clock->seconds > 0 ? fmt::format(":{:02}", clock->seconds) : "";
  written.better = fmt::format("{}-{}-{}T{:02}:{:02}{}Z", year, month, day, clock->hours,
                               clock->minutes, seconds);
  return written;
}

/// How many tokens from the current one on are `length` bytes; 0: one of them is longer.
size_t tokensOf(const Phrase& phrase, size_t length) {
  const uint32_t end = phrase.token().begin + static_cast<uint32_t>(length);
  size_t tokens = 0;
  while (phrase.type(tokens) != kEof && phrase.token(tokens).begin < end) {
    ++tokens;
  }
  return tokens > 0 && phrase.token(tokens - 1).end == end ? tokens : 0;
}

/// Whether a value is to follow here.
bool mayBeginValue(const Phrase& phrase) {
  return !endsValue(phrase.before());
}

std::string_view textFrom(const Phrase& phrase) {
  constexpr size_t kLongest = 40;
  return phrase.source().text().substr(phrase.token().begin, kLongest);
}

}  // namespace

size_t instant(Phrase& phrase) {
  const auto written = mayBeginValue(phrase) ? instantAt(textFrom(phrase)) : std::nullopt;
  const size_t tokens = written ? tokensOf(phrase, written->length) : 0;
  if (tokens < 2) {
    return 0;
  }
  const Lexeme whole = phrase.whole(0, tokens);
  auto report = phrase.reporter().at(whole, support::diagnostics::timeInParts,
                                     phrase.source().text(whole), written->better);
  if (written->utc) {
    report.fix(phrase.source().range(whole), written->better);
  } else {
    report.hint(fmt::format("write `{}`: a time is UTC, and ends with `Z`", written->better));
  }
  phrase.put({GliderLexer::NUMBER, whole.begin, whole.end});
  phrase.notAsMeant();
  return tokens;
}

namespace {

/// Whether the name of the clock of the day, or of the calendar, is a token of the comparison that
/// is being read: `18:00` is a time of the day there, and a duration elsewhere.
bool besideTimeOfDay(const Phrase& phrase, size_t tokens) {
  constexpr size_t kFarthest = 40;
  const auto isDay = [](std::string_view word) { return word == "timeofday" || word == "utc"; };
  const auto ends = [](uint32_t type) {
    return oneOf(type, {GliderLexer::COMMA, GliderLexer::LPAREN, GliderLexer::RPAREN,
                        GliderLexer::AND, GliderLexer::OR, kEof}) ||
           (isHardKeyword(type) && !isOperator(type));
  };
  bool joined = false;  // `and` was passed, as in `between 18:00 and 20:00`
  bool between = false;
  for (size_t k = 0; k < kFarthest && phrase.before(k) != 0; ++k) {
    const std::string_view word = phrase.source().text(*phrase.lexemeBefore(k));
    joined = joined || phrase.before(k) == GliderLexer::AND_WORD;
    between = between || word == "between";
    if (isDay(word)) {
      return !joined || between;
    }
    if (ends(phrase.before(k)) && phrase.before(k) != GliderLexer::AND_WORD) {
      break;
    }
  }
  for (size_t k = tokens; k < tokens + kFarthest && !ends(phrase.type(k)); ++k) {
    if (isDay(phrase.text(k))) {
      return true;
    }
  }
  return false;
}

/// How many hours the clocks of a zone are ahead of UTC.
struct Zone {
  std::string_view name;
  int ahead_h;
};
constexpr Zone kZones[] = {{"UTC", 0},  {"GMT", 0},  {"Z", 0},    {"EST", -5}, {"EDT", -4},
                           {"CST", -6}, {"CDT", -5}, {"MST", -7}, {"MDT", -6}, {"PST", -8},
                           {"PDT", -7}, {"AST", -4}, {"BST", 1},  {"WET", 0},  {"WEST", 1},
                           {"CET", 1},  {"CEST", 2}, {"EET", 2},  {"EEST", 3}, {"JST", 9}};

const Zone* zoneAt(const Phrase& phrase, size_t k) {
  const auto* zone = std::ranges::find(kZones, phrase.text(k), &Zone::name);
  return zone == std::end(kZones) || phrase.startsLine(k) ? nullptr : zone;
}

void putTime(Phrase& phrase, const Lexeme& whole) {
  phrase.put({GliderLexer::NUMBER, whole.begin, whole.end});
  phrase.notAsMeant();
}

/// Reports a time of the day whose zone is token `tokens`.
size_t takeZoned(Phrase& phrase, size_t tokens, Clock clock, const Zone& zone) {
  const Lexeme whole = phrase.whole(0, tokens + 1);
  const int hours = static_cast<int>(clock.hours) - zone.ahead_h;
  clock.hours = static_cast<unsigned>(hours + static_cast<int>(kDay_h)) % kDay_h;
  const std::string better = asDuration(clock);
  auto report = phrase.reporter().at(whole, support::diagnostics::timeInParts,
                                     phrase.source().text(whole), better);
  if (zone.ahead_h == 0) {
    report.fix(phrase.source().range(whole), better);
  } else {
    report.hint(fmt::format("write `{}`: the time of the day is UTC", better));
  }
  putTime(phrase, whole);
  return tokens + 1;
}

/// `6 pm`, `6:30 pm`: the vehicle's clock is UTC, and theirs perhaps not.
size_t takeTwelveHours(Phrase& phrase, size_t tokens, Clock clock) {
  constexpr unsigned kHalf = 12;
  const bool after_noon = phrase.says(tokens, "pm");
  if ((!after_noon && !phrase.says(tokens, "am")) || phrase.startsLine(tokens) ||
      clock.hours == 0 || clock.hours > kHalf) {
    return 0;
  }
  clock.hours = clock.hours % kHalf + (after_noon ? kHalf : 0);
  const Lexeme whole = phrase.whole(0, tokens + 1);
  phrase.reporter()
      .at(whole, support::diagnostics::timeInParts, phrase.source().text(whole), "")
      .hint(fmt::format("write `{}` if that is UTC, as the time of the day is", asDuration(clock)));
  putTime(phrase, whole);
  return tokens + 1;
}

/// `6 pm`.
size_t hourOfTwelve(Phrase& phrase) {
  const std::string_view digits = phrase.text();
  if (digits.size() > 2 || !std::ranges::all_of(digits, isDigit)) {
    return 0;
  }
  return takeTwelveHours(phrase, 1, {numberOf(digits)});
}

}  // namespace

size_t clockTime(Phrase& phrase) {
  if (!mayBeginValue(phrase)) {
    return 0;
  }
  if (phrase.type(1) != GliderLexer::COLON || !phrase.touches(1)) {
    return hourOfTwelve(phrase);
  }
  Reader reader(textFrom(phrase));
  const auto clock = clockAt(reader);
  const size_t tokens = clock ? tokensOf(phrase, reader.at()) : 0;
  if (tokens < 3 || phrase.type(tokens) == GliderLexer::COMPASS) {
    return 0;
  }
  if (const size_t taken = takeTwelveHours(phrase, tokens, *clock)) {
    return taken;
  }
  const bool day = besideTimeOfDay(phrase, tokens);
  if (day && clock->hours > kDay_h) {
    return 0;
  }
  if (const Zone* zone = zoneAt(phrase, tokens)) {
    return takeZoned(phrase, tokens, *clock, *zone);
  }
  const Lexeme whole = phrase.whole(0, tokens);
  const std::string better = asDuration(*clock);
  auto report = phrase.reporter().at(whole, support::diagnostics::timeInParts,
                                     phrase.source().text(whole), better);
  if (day || clock->three) {
    report.fix(phrase.source().range(whole), better);
  } else {
    report.hint(fmt::format("write `{}` for hours and minutes, `{}` for minutes and seconds",
                            better, asMinutes(*clock)));
  }
  putTime(phrase, whole);
  return tokens;
}

size_t remainderSign(Phrase& phrase) {
  const uint32_t left = phrase.before();
  if (phrase.text() != "%" || !(isName(left) || left == GliderLexer::RPAREN)) {
    return 0;
  }
  const bool name = isName(left);
  const size_t period = isName(phrase.type(1)) ? 1 : tokensOfNumber(phrase, 1);
  if (period == 0 || phrase.startsLine(1)) {
    return 0;
  }
  const Lexeme sign = phrase.token();
  const Source& source = phrase.source();
  const std::string_view right = phrase.wholeText(1, period);
  const std::string_view value = name ? source.text(*phrase.lexemeBefore()) : "…";
  const std::string better = fmt::format("remainder({}, {})", value, right);
  auto report = phrase.reporter().at(sign, support::diagnostics::wordOperator, "%", better);
  // `n * 2 % 3` is (n * 2) % 3 in other languages.
  const bool alone = name && !oneOf(phrase.before(1), {GliderLexer::TIMES, GliderLexer::DIVIDE,
                                                       GliderLexer::MINUS, GliderLexer::NOT});
  if (alone) {
    const uint32_t end = phrase.token(period).end;
    report.fix({source.file, phrase.lexemeBefore()->begin, end}, better);
  }
  phrase.put({GliderLexer::DIVIDE, sign.begin, sign.end});
  phrase.notAsMeant();
  return 1;
}

size_t everyMinute(Phrase& phrase) {
  constexpr std::pair<std::string_view, std::string_view> kTimes[] = {
      {"second", "1 s"}, {"minute", "1 min"}, {"hour", "1 h"}};
  const bool alone = !isOperator(phrase.type(1)) && phrase.type(1) != GliderLexer::LPAREN;
  for (const auto& [word, time] : kTimes) {
    if (phrase.before() == GliderLexer::EVERY && alone && phrase.says(0, word) &&
        !phrase.isDeclared(phrase.text())) {
      const Lexeme found = phrase.token();
      phrase.reporter()
          .at(found, support::diagnostics::timeInParts, phrase.text(), time)
          .fix(phrase.source().range(found), std::string(time));
      phrase.put({GliderLexer::NUMBER, found.begin, found.end});
      phrase.notAsMeant();
      return 1;
    }
  }
  return 0;
}

}  // namespace glider::frontend::phrases
