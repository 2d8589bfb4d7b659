// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/repair_positions.h"

#include "frontend/parse/token_kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>

namespace glider::frontend {
namespace {

bool isDegreeSign(std::string_view text) {
  return text == "°" || text == "º" || text == "deg";
}

bool isMinuteOrSecondSign(std::string_view text) {
  constexpr std::array<std::string_view, 5> kSigns = {"'", "′", "’", "″", "''"};
  return std::ranges::find(kSigns, text) != kSigns.end();
}

/// "39.175": degrees from parts of 1, 1/60 and 1/3600, without zeros at the end.
std::string decimal(double degrees) {
  std::string text = fmt::format("{:.6f}", degrees);
  text.erase(text.find_last_not_of('0') + 1);
  return text + (text.back() == '.' ? "0" : "");
}

/// `N39.175`: a name and a number without a space between them.
std::optional<ForeignPosition> letterFirst(const std::vector<Lexeme>& lexemes, size_t at,
                                           const Source& source) {
  const Lexeme& name = lexemes[at];
  const std::string_view text = source.text(name);
  if (name.type != GliderLexer::NAME || at + 1 >= lexemes.size() || text.size() < 2 ||
      std::string_view("NSEW").find(text[0]) == std::string_view::npos ||
      text.find_first_not_of("0123456789", 1) != std::string_view::npos) {
    return std::nullopt;
  }
  const Lexeme& rest = lexemes[at + 1];
  if (rest.type != GliderLexer::NUMBER || rest.begin != name.end || source.text(rest)[0] != '.') {
    return std::nullopt;
  }
  ForeignPosition found;
  found.whole = {GliderLexer::NUMBER, name.begin, rest.end};
  found.count = 2;
  found.number = {GliderLexer::NUMBER, name.begin + 1, rest.end};
  found.letter = {GliderLexer::COMPASS, name.begin, name.begin + 1};
  found.better = fmt::format("{} {}", source.text(found.number), text[0]);
  return found;
}

/// The file may end before that token.
bool isLetter(const std::vector<Lexeme>& lexemes, size_t at) {
  return at < lexemes.size() && lexemes[at].type == GliderLexer::COMPASS;
}

constexpr double kMinutes = 60;

bool areDigits(std::string_view text) {
  return text.find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace

std::optional<Lexeme> degreesAndMinutes(const std::vector<Lexeme>& lexemes, size_t at,
                                        const Source& source) {
  constexpr size_t kTokens = 3;
  constexpr size_t kMostDegrees = 3;  // digits
  if (at + kTokens > lexemes.size() || lexemes[at].type != GliderLexer::NUMBER ||
      lexemes[at + 1].type != GliderLexer::NUMBER || !isLetter(lexemes, at + 2)) {
    return std::nullopt;
  }
  const std::string_view degrees = source.text(lexemes[at]);
  const std::string_view minutes = source.text(lexemes[at + 1]);
  const Lexeme whole{GliderLexer::NUMBER, lexemes[at].begin, lexemes[at + 1].end};
  const std::string_view gap =
      source.text().substr(lexemes[at].end, lexemes[at + 1].begin - lexemes[at].end);
  const bool good = areDigits(degrees) && degrees.size() <= kMostDegrees &&
                    minutes.find_first_of("eE") == std::string_view::npos &&
                    std::strtod(std::string(minutes).c_str(), nullptr) < kMinutes &&
                    gap.find_first_not_of(" \t") == std::string_view::npos;
  return good ? std::optional(whole) : std::nullopt;
}

std::optional<ForeignPosition> foreignPosition(const std::vector<Lexeme>& lexemes, size_t at,
                                               const Source& source) {
  if (lexemes[at].type != GliderLexer::NUMBER) {
    return letterFirst(lexemes, at, source);
  }
  // The last token is the file's end. Most numbers are followed by neither.
  if (lexemes[at + 1].type != GliderLexer::NUMBER && !isDegreeSign(source.text(lexemes[at + 1]))) {
    return std::nullopt;
  }
  double degrees = 0;
  double part = 1;
  bool certain = true;
  bool sign = false;
  std::string as_written;
  size_t i = at;
  for (int numbers = 0; numbers < 3 && lexemes[i].type == GliderLexer::NUMBER; ++numbers) {
    const std::string_view digits = source.text(lexemes[i]);
    const double number = std::strtod(std::string(digits).c_str(), nullptr);
    // `39.5 10 N` and `39 75 N` are typing errors, but it is not known which.
    const bool last = isLetter(lexemes, i + 1) ||
                      (lexemes[i + 1].type != GliderLexer::NUMBER && isLetter(lexemes, i + 2));
    certain = certain && (numbers == 0 || number < kMinutes) && (last || areDigits(digits));
    degrees += number * part;
    part /= kMinutes;
    as_written += fmt::format("{} ", digits);
    ++i;
    const std::string_view next = source.text(lexemes[i]);  // the last token is the file's end
    if (numbers == 0 ? isDegreeSign(next) : isMinuteOrSecondSign(next)) {
      sign = true;
      ++i;
    }
  }
  const bool several = part < 0.5 / kMinutes;
  const bool seconds = part < 0.5 / kMinutes / kMinutes;
  if (lexemes[i].type != GliderLexer::COMPASS || !(several || sign) || degrees > 180) {
    return std::nullopt;
  }
  ForeignPosition found;
  found.whole = {GliderLexer::NUMBER, lexemes[at].begin, lexemes[i].end};
  found.count = i - at + 1;
  // On two lines they may belong to two things, one of them misspelt.
  const std::string_view text = source.text(found.whole);
  found.certain = certain && text.find('\n') == std::string_view::npos;
  found.number = lexemes[at];
  found.letter = lexemes[i];
  const bool minutes = several && !seconds && found.certain;
  found.better =
      (minutes ? as_written : decimal(degrees) + " ") + std::string(source.text(lexemes[i]));
  return found;
}

}  // namespace glider::frontend
