// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/bare_positions.h"
#include "frontend/compass.h"
#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <optional>

namespace glider::frontend::phrases {
namespace {

/// Half of a position: a number, perhaps with a sign before and a letter after it.
struct Half {
  size_t at = 0;  ///< its number
  bool negative = false;
  bool letter = false;
  size_t end = 0;  ///< past its last token
};

std::optional<Half> halfAt(const Phrase& phrase, size_t k) {
  Half half;
  half.negative = phrase.type(k) == GliderLexer::MINUS;
  half.at = k + (half.negative ? 1 : 0);
  if (phrase.type(half.at) != GliderLexer::NUMBER) {
    return std::nullopt;
  }
  half.letter = phrase.type(half.at + 1) == GliderLexer::COMPASS;
  half.end = half.at + (half.letter ? 2 : 1);
  return half;
}

/// Two halves as they are written outside the arguments of a name.
struct Pair {
  Half first;
  Half second;
  size_t end = 0;
  bool comma = false;
  bool enclosed = false;  ///< in `(…)` or `[…]`
};

std::optional<Pair> pairAt(const Phrase& phrase) {
  Pair pair;
  const uint32_t opener = phrase.type();
  pair.enclosed =
      opener == GliderLexer::LPAREN || (opener == GliderLexer::LBRACKET && !phrase.open().empty());
  const auto first = halfAt(phrase, pair.enclosed ? 1 : 0);
  if (!first) {
    return std::nullopt;
  }
  pair.first = *first;
  pair.comma = phrase.type(first->end) == GliderLexer::COMMA;
  const auto second = halfAt(phrase, first->end + (pair.comma ? 1 : 0));
  if (!second) {
    return std::nullopt;
  }
  pair.second = *second;
  pair.end = second->end + (pair.enclosed ? 1 : 0);
  const uint32_t closer =
      opener == GliderLexer::LPAREN ? GliderLexer::RPAREN : GliderLexer::RBRACKET;
  const bool closed = !pair.enclosed || phrase.type(second->end) == closer;
  return closed ? std::optional(pair) : std::nullopt;
}

/// The pair as the language writes it.
struct Better {
  std::string text;
  bool certain = false;
};

/// With its letters: only the sign of a longitude that has a letter too may be wrong.
std::optional<Better> lettered(const Phrase& phrase, const Pair& pair) {
  const std::string_view north = phrase.text(pair.first.at + 1);
  const std::string_view east = phrase.text(pair.second.at + 1);
  if (!(north == "N" || north == "S") || !(east == "E" || east == "W")) {
    return std::nullopt;
  }
  const auto write = [&](std::string_view n, std::string_view e) {
    return fmt::format("{} {} {} {}", phrase.text(pair.first.at), n, phrase.text(pair.second.at),
                       e);
  };
  if (!pair.first.negative && !pair.second.negative) {
    return Better{fmt::format("`{}`", write(north, east)), true};
  }
  const auto other = [](std::string_view letter) {
    constexpr std::string_view kLetters = "NSEW";
    constexpr std::string_view kOpposite = "SNWE";
    return kOpposite.substr(kLetters.find(letter), 1);
  };
  return Better{fmt::format("`{}` or `{}`", write(north, east),
                            write(pair.first.negative ? other(north) : north,
                                  pair.second.negative ? other(east) : east)),
                false};
}

/// Without letters: degrees and minutes as the vehicle writes them, or decimal degrees. A minus
/// says on which side a number is; without one, a letter may have been forgotten.
std::optional<Better> bare(const Phrase& phrase, const Pair& pair) {
  const std::string_view north = phrase.text(pair.first.at);
  const std::string_view east = phrase.text(pair.second.at);
  const bool signed_east = pair.second.negative;
  if (isPlainlyDdmm(north) && isPlainlyDdmm(east)) {
    const auto text = pairWithLetters({north, pair.first.negative}, {east, signed_east});
    const bool ordered = !isLongitudeFirst(valueOf(north) / 100, valueOf(east) / 100);
    return text ? std::optional(Better{fmt::format("`{}`", *text), signed_east && ordered})
                : std::nullopt;
  }
  constexpr double kMostLatitude = 90;
  constexpr double kMostLongitude = 180;
  constexpr double kMinutes = 60;
  const double a = valueOf(north);
  const double b = valueOf(east);
  if (a > kMostLatitude && a <= kMostLongitude && b <= kMostLatitude) {  // the longitude first
    const auto turned = [&](char letter) {
      return fmt::format("`{} {} {} {}`", east, pair.second.negative ? 'S' : 'N', north, letter);
    };
    return Better{pair.first.negative ? turned('W') : turned('E') + " or " + turned('W'), false};
  }
  if (a > kMostLatitude || b > kMostLongitude) {
    return std::nullopt;
  }
  const auto write = [&](bool west) {
    return fmt::format("{} {} {} {}", north, pair.first.negative ? 'S' : 'N', east,
                       west ? 'W' : 'E');
  };
  // What cannot be minutes is degrees, and so is its other half.
  const bool degrees = a >= kMinutes || b >= kMinutes;
  const bool ordered = !isLongitudeFirst(a, b);
  return Better{signed_east ? fmt::format("`{}`", write(true))
                            : fmt::format("`{}` or `{}`", write(false), write(true)),
                signed_east && degrees && ordered};
}

/// Whether what is left of a list is pairs of bare numbers, and positions with their letters.
bool isListOfPairs(const Phrase& phrase) {
  constexpr size_t kMostHalves = 200;
  size_t bare = 0;
  for (size_t k = 0, halves = 0; halves < kMostHalves; ++halves, ++k) {
    const auto half = halfAt(phrase, k);
    const auto second = half && half->letter ? halfAt(phrase, half->end) : std::nullopt;
    if (!half || (half->letter && (bare % 2 != 0 || !second || !second->letter))) {
      return false;
    }
    bare += half->letter ? 0U : 1U;
    k = second ? second->end : half->end;
    if (phrase.type(k) != GliderLexer::COMMA) {
      return bare % 2 == 0 && phrase.type(k) == GliderLexer::RBRACKET;
    }
  }
  return false;
}

/// Whether a position with letters is among the values up to the `]`.
bool restHasLetters(const Phrase& phrase) {
  constexpr size_t kMostOfList = 1000;
  for (size_t k = 0; k < kMostOfList; ++k) {
    if (oneOf(phrase.type(k), {GliderLexer::RBRACKET, kEof, GliderLexer::COMPASS})) {
      return phrase.type(k) == GliderLexer::COMPASS;
    }
  }
  return false;
}

/// Whether the list that is being read is the value of a declaration of something else than a path.
bool isOfAnArray(const Phrase& phrase) {
  bool assigned = false;
  for (size_t k = 0;; ++k) {
    const Lexeme* before = phrase.lexemeBefore(k);
    if (before == nullptr || before->type == GliderLexer::LPAREN) {
      return false;
    }
    if (oneOf(before->type, {GliderLexer::CONST, GliderLexer::VAR, GliderLexer::PARAM})) {
      return assigned;
    }
    assigned = assigned || before->type == GliderLexer::ASSIGN;
    if (phrase.source().text(*before) == "path" && phrase.before(k + 1) == GliderLexer::COLON) {
      return false;
    }
  }
}

/// Whether every value from here to the `]` is two numbers with a space between them, and no sign:
/// `39.175 73.83, 39.2 73.8`.
bool isListOfHalves(const Phrase& phrase) {
  constexpr size_t kMostPairs = 100;
  for (size_t k = 0, pairs = 0; pairs < kMostPairs; ++pairs) {
    const auto first = halfAt(phrase, k);
    const auto second = first ? halfAt(phrase, first->end) : std::nullopt;
    const auto plain = [&](const Half& half) {
      return !half.letter && !half.negative && !isPlainlyDdmm(phrase.text(half.at));
    };
    if (!second || !plain(*first) || !plain(*second)) {
      return false;
    }
    k = second->end;
    if (phrase.type(k) != GliderLexer::COMMA) {
      return phrase.type(k) == GliderLexer::RBRACKET;
    }
    ++k;
  }
  return false;
}

/// Whether a position of the list that is being read was reported: the others have the same error.
bool reportedInList(const Phrase& phrase) {
  for (size_t k = 0; phrase.before(k) != 0 && phrase.before(k) != GliderLexer::LBRACKET; ++k) {
    const std::string_view text = phrase.source().text(*phrase.lexemeBefore(k));
    if (phrase.before(k) == GliderLexer::NUMBER && text.find_first_of(" ,") != text.npos) {
      return !phrase.open().empty() && phrase.open().back().type == GliderLexer::LBRACKET;
    }
  }
  return false;
}

/// Whether a pair without parentheses can be meant: between the values of a path, or as the whole
/// value of a constant.
bool mayBePair(const Phrase& phrase, const Pair& pair) {
  const bool path = !phrase.open().empty() && phrase.open().back().type == GliderLexer::LBRACKET;
  const bool fraction = phrase.text(pair.first.at).find('.') != std::string_view::npos &&
                        phrase.text(pair.second.at).find('.') != std::string_view::npos;
  const uint32_t next = phrase.type(pair.end);
  const bool assigned = phrase.before() == GliderLexer::ASSIGN;
  if (isOperator(next) || !(path || assigned)) {
    return false;
  }
  const bool ends = path && oneOf(next, {GliderLexer::COMMA, GliderLexer::RBRACKET});
  // `39.175 -73.83`: a sign that touches its number only.
  const size_t sign = pair.second.at - 1;
  const bool sign_of_number =
      pair.second.negative && !phrase.touches(sign) && phrase.touches(sign + 1);
  if (!pair.comma && !pair.enclosed && ends && fraction && isListOfHalves(phrase) &&
      !isOfAnArray(phrase)) {
    return true;
  }
  // `= 39.175 73.83`: two numbers next to each other can be nothing else.
  if (!pair.comma && !pair.enclosed && assigned && fraction && !pair.first.letter &&
      !isPlainlyDdmm(phrase.text(pair.first.at)) && !pair.second.negative &&
      phrase.startsLine(pair.end)) {
    return true;
  }
  if (!pair.comma) {
    return !pair.enclosed && ends && sign_of_number &&
           (pair.first.letter || !isPlainlyDdmm(phrase.text(pair.first.at)));
  }
  if (pair.enclosed || assigned) {
    return pair.first.letter || fraction;
  }
  const bool path_by_letters = ends && !pair.first.letter && restHasLetters(phrase);
  return ends && (pair.first.letter ||
                  (isListOfPairs(phrase) && (path_by_letters || !isOfAnArray(phrase))));
}

void putPair(Phrase& phrase, const Pair& pair) {
  if (pair.first.letter) {
    for (const Half& half : {pair.first, pair.second}) {
      phrase.put(phrase.token(half.at));
      phrase.put(phrase.token(half.at + 1));
    }
    return;
  }
  // One number with a space or a comma in it: analysis knows that it was reported.
  const size_t first = pair.first.at;
  phrase.put(phrase.whole(first, pair.second.end - first, GliderLexer::NUMBER));
}

}  // namespace

namespace {

/// `= 39 10.5 -73 50.0`, `= 39 10.5, 73 50.0`: degrees and minutes without letters.
size_t degreesAndMinutesAlone(Phrase& phrase) {
  const auto number = [&](size_t k) { return phrase.type(k) == GliderLexer::NUMBER; };
  const size_t south = phrase.type() == GliderLexer::MINUS ? 1 : 0;
  const size_t comma = phrase.type(south + 2) == GliderLexer::COMMA ? 1 : 0;
  const size_t west = phrase.type(south + comma + 2) == GliderLexer::MINUS ? 1 : 0;
  const size_t second = south + comma + west + 2;
  const size_t end = second + 2;
  if (phrase.before() != GliderLexer::ASSIGN || !number(south) || !number(south + 1) ||
      !number(second) || !number(second + 1) || !phrase.startsLine(end)) {
    return 0;
  }
  const auto with = [&](char letter) {
    return fmt::format("{} {} {} {}", phrase.wholeText(south, 2), south > 0 ? 'S' : 'N',
                       phrase.wholeText(second, 2), letter);
  };
  const Lexeme whole = phrase.whole(0, end);
  auto report = phrase.reporter().at(whole, support::diagnostics::positionForm,
                                     phrase.source().text(whole), with('W'));
  if (west > 0) {
    report.fix(phrase.source().range(whole), with('W'));
  } else {
    report.hint(fmt::format("write `{}` or `{}`", with('E'), with('W')));
  }
  phrase.put({GliderLexer::NUMBER, whole.begin, whole.end});
  return end;
}

}  // namespace

size_t pairOfNumbers(Phrase& phrase) {
  if (const size_t taken = degreesAndMinutesAlone(phrase)) {
    return taken;
  }
  const bool begins = oneOf(phrase.type(), {GliderLexer::LPAREN, GliderLexer::LBRACKET,
                                            GliderLexer::NUMBER, GliderLexer::MINUS});
  const bool place =
      oneOf(phrase.before(), {GliderLexer::ASSIGN, GliderLexer::LBRACKET, GliderLexer::COMMA});
  const auto pair = begins && place ? pairAt(phrase) : std::nullopt;
  if (!pair || pair->first.letter != pair->second.letter || !mayBePair(phrase, *pair)) {
    return 0;
  }
  const auto better = pair->first.letter ? lettered(phrase, *pair) : bare(phrase, *pair);
  if (!better) {
    return 0;
  }
  if (!pair->first.letter && !better->certain && reportedInList(phrase)) {
    putPair(phrase, *pair);
    return pair->end;
  }
  const Lexeme whole = phrase.whole(0, pair->end);
  auto report = phrase.reporter().at(whole, support::diagnostics::positionForm,
                                     phrase.source().text(whole), "");
  report.hint("write " + better->text);
  if (better->certain) {
    report.fix(phrase.source().range(whole), better->text.substr(1, better->text.size() - 2));
  }
  putPair(phrase, *pair);
  return pair->end;
}

size_t commaInPosition(Phrase& phrase) {
  const auto letter = [&](const Lexeme& one, std::string_view a, std::string_view b) {
    const std::string_view text = phrase.source().text(one);
    return one.type == GliderLexer::COMPASS && (text == a || text == b);
  };
  const Lexeme* before = phrase.lexemeBefore();
  const size_t numbers = phrase.type(2) == GliderLexer::NUMBER ? 2 : 1;
  const bool value = oneOf(phrase.keyword(), {GliderLexer::CONST, GliderLexer::PARAM,
                                              GliderLexer::VAR, GliderLexer::SET});
  if (!value || !phrase.open().empty() || before == nullptr || !letter(*before, "N", "S") ||
      phrase.type(1) != GliderLexer::NUMBER || !letter(phrase.token(1 + numbers), "E", "W")) {
    return 0;
  }
  const Lexeme comma = phrase.token();
  phrase.reporter()
      .at(comma, support::diagnostics::superfluousWord, ",", "within a position")
      .fix(phrase.source().range(comma), "");
  return 1;
}

namespace {

/// A word of a point, `south` or `S`.
bool isPointWord(const Phrase& phrase, size_t k) {
  return phrase.type(k) == GliderLexer::COMPASS ||
         (phrase.type(k) == GliderLexer::NAME && phrase.text(k).size() > 3 &&
          !compassAngle(phrase.text(k)).empty());
}

/// The tokens of `south-east`, `north north east` from the current one on; 1: it has one word.
size_t tokensOfPoint(Phrase& phrase) {
  size_t tokens = 1;
  for (size_t words = 1; words < 3; ++words) {
    const size_t next = tokens + (phrase.type(tokens) == GliderLexer::MINUS ? 1 : 0);
    if (!isPointWord(phrase, next) || phrase.startsLine(next) ||
        phrase.isDeclared(phrase.text(next))) {
      break;
    }
    tokens = next + 1;
  }
  return compassAngle(phrase.wholeText(0, tokens)).empty() ? 1 : tokens;
}

}  // namespace

size_t compassPoint(Phrase& phrase) {
  if (endsValue(phrase.before()) || !isPointWord(phrase, 0) || phrase.isDeclared(phrase.text())) {
    return 0;
  }
  const size_t tokens = tokensOfPoint(phrase);
  const bool alone = phrase.before() == GliderLexer::LPAREN &&
                     phrase.type(1) == GliderLexer::RPAREN && !phrase.open().empty() &&
                     phrase.open().back().arguments;
  // One word that is a name may be a sensor of the platform: analysis knows.
  if (tokens == 1 && !(alone && phrase.type() == GliderLexer::COMPASS)) {
    return 0;
  }
  const Lexeme point = phrase.whole(0, tokens);
  const std::string better = compassAngle(phrase.source().text(point));
  phrase.reporter()
      .at(point, support::diagnostics::unexpectedToken, "an angle",
          fmt::format("`{}`", phrase.source().text(point)))
      .hint(fmt::format("write `{}`", better))
      .fix(phrase.source().range(point), better);
  phrase.put({GliderLexer::NUMBER, point.begin, point.end});
  phrase.notAsMeant();
  return tokens;
}

}  // namespace glider::frontend::phrases
