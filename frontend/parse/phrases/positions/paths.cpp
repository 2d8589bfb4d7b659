// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <string>

namespace glider::frontend::phrases {
namespace {

constexpr size_t kMostTokens = 300;

/// Whether the value of a declaration of a path begins at the current token.
bool beginsPath(const Phrase& phrase) {
  return phrase.before() == GliderLexer::ASSIGN && phrase.open().empty() &&
         phrase.before(2) == GliderLexer::COLON &&
         phrase.source().text(*phrase.lexemeBefore(1)) == "path";
}

/// The same without its type: `const track =`.
bool beginsConstant(const Phrase& phrase) {
  return phrase.before() == GliderLexer::ASSIGN && phrase.open().empty() &&
         phrase.before(2) == GliderLexer::CONST;
}

/// Positions with commas between them.
struct Positions {
  size_t end = 0;      ///< past the last token
  size_t letters = 0;  ///< `N`, `S`, `E` and `W`
  size_t commas = 0;
  size_t first_comma = 0;
  bool names = false;
  [[nodiscard]] bool several() const { return commas > 0 && (letters > 2 || names); }
};

/// Those from token `first` on: to the `)` if they are in parentheses, otherwise to the end of the
/// line that has no comma at its end.
Positions positionsFrom(const Phrase& phrase, size_t first, bool enclosed) {
  Positions found;
  size_t deep = 0;
  size_t k = first;
  for (; k - first < kMostTokens; ++k) {
    const uint32_t type = phrase.type(k);
    const bool goes_on =
        k == first || phrase.type(k - 1) == GliderLexer::COMMA || !phrase.startsLine(k);
    const bool part = startsValue(type) || isAnyName(type) ||
                      oneOf(type, {GliderLexer::COMMA, GliderLexer::MINUS, GliderLexer::LPAREN,
                                   GliderLexer::RPAREN, GliderLexer::FOREIGN});
    if (!part || (!enclosed && !goes_on) || (type == GliderLexer::RPAREN && deep == 0)) {
      break;
    }
    deep += type == GliderLexer::LPAREN ? 1U : 0U;
    deep -= type == GliderLexer::RPAREN ? 1U : 0U;
    if (type == GliderLexer::COMMA && deep == 0) {
      found.first_comma = found.commas == 0 ? k : found.first_comma;
      ++found.commas;
    }
    found.letters += type == GliderLexer::COMPASS ? 1U : 0U;
    found.names = found.names || (deep == 0 && type == GliderLexer::NAME);
  }
  found.end = k;
  return found;
}

/// `lat`, `latitude`, `m_gps_lat` with what has `lon` in its place.
bool isLatitudeWithLongitude(const std::string& first, const std::string& second) {
  const size_t at = first.find("lat");
  if (at == std::string::npos) {
    return false;
  }
  std::string other = first;
  other.replace(at, 3, "lon");
  const size_t tail = other.find("lonitude");
  if (tail != std::string::npos) {
    other.replace(tail, std::string("lonitude").size(), "longitude");
  }
  return second == other;
}

}  // namespace

size_t pathWithoutBrackets(Phrase& phrase) {
  const bool round = phrase.type() == GliderLexer::LPAREN;
  const bool declared = beginsPath(phrase);
  const bool constant = !round && phrase.type() == GliderLexer::NUMBER && beginsConstant(phrase);
  if (!declared && !constant && (!round || isAnyName(phrase.before()) || phrase.before() == 0)) {
    return 0;
  }
  const Positions found = positionsFrom(phrase, round ? 1 : 0, round);
  const bool closed = !round || phrase.type(found.end) == GliderLexer::RPAREN;
  if (!closed || !found.several() || (found.names && !declared)) {
    return 0;
  }
  const size_t first = round ? 1 : 0;
  const bool ended = !round && phrase.type(found.end) == GliderLexer::RBRACKET;
  const Lexeme last = phrase.token(round ? found.end : found.end - 1);
  const support::SourceRange whole{phrase.source().file, phrase.token().begin, last.end};
  auto report = phrase.reporter().at(phrase.whole(0, found.end + first),
                                     support::diagnostics::listWithoutBrackets,
                                     phrase.wholeText(first, found.first_comma - first));
  if (round) {
    report.fix({whole.file, whole.begin, whole.begin + 1}, "[")
        .fix({whole.file, whole.end - 1, whole.end}, "]");
    phrase.leaveOut(found.end);
  } else {
    report.fix({whole.file, whole.begin, whole.begin}, "[");
  }
  if (!round && !ended) {
    report.fix({whole.file, whole.end, whole.end}, "]");
  }
  if (!ended) {
    phrase.supplyBefore(found.end, GliderLexer::RBRACKET);
  }
  if (round) {
    const Lexeme opener = phrase.token();
    phrase.put({GliderLexer::LBRACKET, opener.begin, opener.end});
    return 1;
  }
  phrase.insert(GliderLexer::LBRACKET);
  return 0;
}

size_t latitudeWithLongitude(Phrase& phrase) {
  const bool value = oneOf(phrase.before(), {GliderLexer::ASSIGN, GliderLexer::LPAREN,
                                             GliderLexer::LBRACKET, GliderLexer::COMMA});
  const bool assigned = phrase.before() == GliderLexer::ASSIGN && phrase.open().empty();
  const size_t comma = assigned && phrase.type(1) == GliderLexer::COMMA ? 1 : 0;
  const size_t second = 1 + comma;
  if (!value || !isName(phrase.type(second)) || phrase.startsLine(second) ||
      !isLatitudeWithLongitude(phrase.lower(), phrase.lower(second))) {
    return 0;
  }
  const Lexeme whole = phrase.whole(0, second + 1);
  const bool here = phrase.text() == "lat" || phrase.text() == "m_lat";
  phrase.reporter()
      .at(whole, support::diagnostics::positionForm, phrase.source().text(whole), "")
      .hint(fmt::format("write `position({}, {})`{}", phrase.text(), phrase.text(second),
                        here ? ", or `here`" : ""));
  // One number with a space in it: analysis knows that it was reported.
  phrase.put({GliderLexer::NUMBER, whole.begin, whole.end});
  phrase.notAsMeant();
  return second + 1;
}

}  // namespace glider::frontend::phrases
