// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/bare_positions.h"
#include "frontend/parse/phrases/positions/written_position.h"
#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"
#include "support/diagnostics/ids/meaning.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <cstdlib>
#include <optional>
#include <string>

namespace glider::frontend::phrases {
namespace {

using Form = WrittenHalf::Form;

/// A latitude and a longitude next to each other, as written.
struct WrittenPair {
  WrittenHalf first;
  WrittenHalf second;
  bool comma = false;
  [[nodiscard]] bool swapped() const { return !first.latitude(); }
};

Lexeme wholeOf(const WrittenHalf& half) {
  return {GliderLexer::NUMBER, static_cast<uint32_t>(half.begin), static_cast<uint32_t>(half.end)};
}

/// Whether a value begins at the current token, so that a letter there can begin a position.
bool letterMayBegin(const Phrase& phrase) {
  return oneOf(phrase.before(), {GliderLexer::LPAREN, GliderLexer::LBRACKET, GliderLexer::COMMA,
                                 GliderLexer::ASSIGN, GliderLexer::COMPASS});
}

/// The number of tokens from the current one to the byte `end`; 0 if a token goes across it.
size_t tokensTo(const Phrase& phrase, size_t end) {
  constexpr size_t kMostOfPosition = 40;
  size_t k = 0;
  while (k < kMostOfPosition && phrase.token(k).end < end && phrase.type(k) != kEof) {
    ++k;
  }
  return phrase.token(k).end == end ? k + 1 : 0;
}

std::optional<WrittenPair> pairFrom(const Phrase& phrase, const WrittenHalf& first) {
  const std::string_view text = phrase.source().text();
  constexpr std::string_view kBlanks = " \t";
  WrittenPair pair{first, {}, false};
  size_t at = text.find_first_not_of(kBlanks, first.end);
  if (at != text.npos && text[at] == ',') {
    pair.comma = true;
    at = text.find_first_not_of(kBlanks, at + 1);
  }
  const auto second = at == text.npos ? std::nullopt : writtenHalf(text, at, first.letter_first);
  if (!second || second->latitude() == first.latitude() || tokensTo(phrase, second->end) == 0) {
    return std::nullopt;
  }
  pair.second = *second;
  return pair;
}

/// Whether a half can be nothing else: `5 s` is a time. There are no differences of latitudes, so
/// `39-10.5 N` is none.
bool standsAlone(const WrittenHalf& half) {
  return (half.form == Form::Other || half.minutes_over_60) && !half.comma &&
         !(half.small && half.numbers == 1) && !(half.letter_first && half.small);
}

/// Whether a half in another form that is next to its other half can be nothing else: `5 s` may
/// be a time.
bool isPlain(const WrittenHalf& half) {
  return half.form == Form::Ours || half.numbers > 1 || half.word || half.sign ||
         half.digits.find('.') != half.digits.npos;
}

/// Whether two halves can be nothing else, and one of them is in another form: `f(39,5 N, 73,8 W)`
/// may have four values.
bool standsTogether(const WrittenPair& pair) {
  const bool other = pair.first.form == Form::Other || pair.second.form == Form::Other;
  const bool values = pair.comma && ((pair.first.comma && pair.first.numbers == 1) ||
                                     (pair.second.comma && pair.second.numbers == 1));
  return other && !values && isPlain(pair.first) && isPlain(pair.second) &&
         !(pair.comma && pair.swapped());
}

void putHalf(Phrase& phrase, const WrittenHalf& half) {
  const auto at = [](size_t place) { return static_cast<uint32_t>(place); };
  // With minutes that do not exist only the degrees: the error is reported once.
  const size_t digits = phrase.source().text().find_first_not_of("0123456789", half.number);
  const size_t end = half.minutes_over_60 ? digits : half.number_end;
  phrase.put({GliderLexer::NUMBER, at(half.number), at(end)});
  phrase.put({GliderLexer::COMPASS, at(half.letter_at), at(half.letter_at + 1)});
}

/// `39 60.5 N`: which of the two numbers is wrong is not known.
void reportMinutes(Phrase& phrase, const WrittenHalf& half) {
  const Lexeme whole = wholeOf(half);
  phrase.reporter()
      .at(whole, support::diagnostics::minutesOver60, phrase.source().text(whole), half.whole,
          half.minutes)
      .hint(fmt::format("write minutes below 60, as in `{:.0f} 10.5 {}`", half.whole, half.letter));
}

void reportForm(Phrase& phrase, const Lexeme& whole, const std::string& better, bool certain) {
  auto report = phrase.reporter().at(whole, support::diagnostics::positionForm,
                                     phrase.source().text(whole), better);
  if (certain) {
    report.fix(phrase.source().range(whole), better);
  }
}

void reportHalf(Phrase& phrase, const WrittenHalf& half) {
  if (half.minutes_over_60) {
    reportMinutes(phrase, half);
  } else if (half.form == Form::Other) {
    reportForm(phrase, wholeOf(half), half.better(), half.certain);
  }
}

size_t takeHalf(Phrase& phrase, const WrittenHalf& half) {
  const size_t tokens = tokensTo(phrase, half.end);
  if (tokens == 0 || !standsAlone(half)) {
    return 0;
  }
  reportHalf(phrase, half);
  putHalf(phrase, half);
  return tokens;
}

/// One error for both halves, unless one of them is right or has minutes that do not exist.
void reportPair(Phrase& phrase, const WrittenPair& pair, bool list) {
  const WrittenHalf& north = pair.swapped() ? pair.second : pair.first;
  const WrittenHalf& east = pair.swapped() ? pair.first : pair.second;
  const bool both = pair.first.form == Form::Other && pair.second.form == Form::Other;
  if (!both || north.minutes_over_60 || east.minutes_over_60) {
    const bool first = pair.first.minutes_over_60 ||
                       (pair.first.form == Form::Other && !pair.second.minutes_over_60);
    reportHalf(phrase, first ? pair.first : pair.second);
    return;
  }
  const Lexeme whole{GliderLexer::NUMBER, wholeOf(pair.first).begin, wholeOf(pair.second).end};
  reportForm(phrase, whole, north.better() + (list ? ", " : " ") + east.better(),
             north.certain && east.certain);
}

size_t takePair(Phrase& phrase, const WrittenPair& pair) {
  const size_t tokens = tokensTo(phrase, pair.second.end);
  const bool list = pair.comma && !phrase.open().empty() && phrase.open().back().arguments;
  reportPair(phrase, pair, list);
  putHalf(phrase, pair.swapped() ? pair.second : pair.first);
  if (list) {
    phrase.insert(GliderLexer::COMMA);
  }
  putHalf(phrase, pair.swapped() ? pair.first : pair.second);
  return tokens;
}

/// `73.83` after a half with its letter: the other half, whose letter is missing, or `-73 50.0 W`,
/// whose sign may be wrong, or `73 50.0 O`, whose letter is one of another language.
struct Lost {
  size_t number = 0;  ///< its token
  size_t last = 0;    ///< past the last number
  size_t end = 0;     ///< past its last token
  bool negative = false;
  bool lettered = false;
};

std::optional<Lost> withoutLetter(const Phrase& phrase, size_t k) {
  Lost lost;
  lost.negative = phrase.type(k) == GliderLexer::MINUS && phrase.touches(k + 1);
  lost.number = k + (lost.negative ? 1 : 0);
  if (phrase.type(lost.number) != GliderLexer::NUMBER || phrase.startsLine(k) ||
      (lost.negative && isPlainlyDdmm(phrase.text(lost.number)))) {
    return std::nullopt;
  }
  const bool two = phrase.type(lost.number + 1) == GliderLexer::NUMBER;
  lost.last = lost.number + (two ? 2 : 1);
  const bool foreign = phrase.type(lost.last) == GliderLexer::NAME &&
                       !phrase.startsLine(lost.last) &&
                       (phrase.text(lost.last) == "O" || phrase.text(lost.last) == "o");
  const bool signed_letter = lost.negative && two && phrase.type(lost.last) == GliderLexer::COMPASS;
  lost.lettered = foreign || signed_letter;
  lost.end = lost.last + (lost.lettered ? 1 : 0);
  const bool ends = phrase.startsLine(lost.end) ||
                    oneOf(phrase.type(lost.end),
                          {GliderLexer::COMMA, GliderLexer::RPAREN, GliderLexer::RBRACKET, kEof});
  return ends ? std::optional(lost) : std::nullopt;
}

/// `39.175 N 73.83`: the side of the second half is known only from a minus.
size_t takeOneLetter(Phrase& phrase, const WrittenHalf& first) {
  const size_t tokens = tokensTo(phrase, first.end);
  const bool value = !phrase.open().empty() || phrase.before() == GliderLexer::ASSIGN;
  const auto lost = tokens == 0 || !value ? std::nullopt : withoutLetter(phrase, tokens);
  if (!lost) {
    return 0;
  }
  const std::string_view number = phrase.wholeText(lost->number, lost->last - lost->number);
  const std::string_view letters = first.latitude() ? "EW" : "NS";
  const auto with = [&](size_t letter) {
    return fmt::format("{} {} {}", first.better(), number, letters[letter]);
  };
  const Lexeme whole = phrase.whole(0, lost->end);
  auto report = phrase.reporter().at(whole, support::diagnostics::positionForm,
                                     phrase.source().text(whole), with(1));
  if (lost->negative && !lost->lettered) {
    report.fix(phrase.source().range(whole), with(1));
  } else {
    report.hint(fmt::format("write `{}` or `{}`", with(0), with(1)));
  }
  // One number with a space in it: analysis knows that it was reported.
  phrase.put({GliderLexer::NUMBER, whole.begin, whole.end});
  return lost->end;
}

/// `39.175 73.83 W`: not degrees and minutes, but a latitude whose letter is missing.
bool lacksLatitude(const WrittenHalf& half, std::string_view text) {
  return half.numbers == 2 && !half.sign && !half.latitude() && !half.letter_first &&
         half.minutes <= 180 && half.whole <= 90 &&
         text.substr(half.number, half.number_end - half.number).find('.') <
             text.substr(half.number, half.number_end - half.number).find(' ');
}

size_t takeOneLongitude(Phrase& phrase, const WrittenHalf& half) {
  const size_t tokens = tokensTo(phrase, half.end);
  if (tokens < 3) {
    return 0;
  }
  const Lexeme whole = phrase.whole(0, tokens);
  const auto with = [&](char letter) {
    return fmt::format("`{} {} {} {}`", phrase.text(), letter, phrase.text(1), half.letter);
  };
  phrase.reporter()
      .at(whole, support::diagnostics::positionForm, phrase.source().text(whole), "")
      .hint(fmt::format("write {} or {}", with('N'), with('S')));
  phrase.put({GliderLexer::NUMBER, whole.begin, whole.end});
  return tokens;
}

/// Whether more of a half can follow the number at the current token: most numbers have a unit.
bool mayGoOn(const Phrase& phrase) {
  const uint32_t next = phrase.type(1);
  if (next == GliderLexer::UNIT) {
    return phrase.text(1) == "deg" ||
           (phrase.text(1) == "s" && phrase.type(2) == GliderLexer::NUMBER);
  }
  return oneOf(next, {GliderLexer::COMPASS, GliderLexer::NUMBER, GliderLexer::NAME,
                      GliderLexer::HEARD, GliderLexer::FOREIGN}) ||
         (oneOf(next, {GliderLexer::MINUS, GliderLexer::COLON, GliderLexer::COMMA}) &&
          phrase.touches(1) && phrase.touches(2));
}

}  // namespace

size_t declinationWithLetter(Phrase& phrase) {
  if (phrase.before() != GliderLexer::DECLINATION || !mayGoOn(phrase)) {
    return 0;
  }
  const auto half = writtenHalf(phrase.source().text(), phrase.token().begin, false);
  const size_t tokens = half && !half->latitude() ? tokensTo(phrase, half->end) : 0;
  if (tokens == 0 || half->numbers > 1 || !phrase.startsLine(tokens)) {
    return 0;
  }
  const Lexeme whole = wholeOf(*half);
  const std::string better = fmt::format("{}{} deg", half->letter == 'W' ? "-" : "", half->digits);
  phrase.reporter()
      .at(whole, support::diagnostics::unexpectedToken, "an angle",
          fmt::format("`{}`", phrase.source().text(whole)))
      .hint(fmt::format("write `declination {}`{}", better,
                        half->letter == 'W' ? ": west is below 0" : ""))
      .fix(phrase.source().range(whole), better);
  phrase.put(phrase.token());
  phrase.put({GliderLexer::UNIT, whole.end, whole.end});
  phrase.notAsMeant();
  return tokens;
}

size_t writtenPosition(Phrase& phrase) {
  if (phrase.type() == GliderLexer::NUMBER && !mayGoOn(phrase)) {
    return 0;
  }
  const bool letter_first = phrase.type() != GliderLexer::NUMBER;
  if (phrase.before() == GliderLexer::NUMBER || wantsName(phrase.before()) ||
      (letter_first && !letterMayBegin(phrase))) {
    return 0;
  }
  const auto half = writtenHalf(phrase.source().text(), phrase.token().begin, letter_first);
  if (!half) {
    return 0;
  }
  if (lacksLatitude(*half, phrase.source().text())) {
    return takeOneLongitude(phrase, *half);
  }
  const auto pair = pairFrom(phrase, *half);
  if (!pair && half->form == Form::Ours && !half->minutes_over_60) {
    return takeOneLetter(phrase, *half);
  }
  return pair && standsTogether(*pair) ? takePair(phrase, *pair) : takeHalf(phrase, *half);
}

}  // namespace glider::frontend::phrases
