// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <array>

namespace glider::frontend::phrases {
namespace {

bool isOutages(const Phrase& phrase, size_t k) {
  return phrase.type(k) == GliderLexer::NAME && phrase.says(k, "outages");
}

/// `no outages`.
size_t noOutages(Phrase& phrase) {
  if (phrase.type() != GliderLexer::NO || !isOutages(phrase, 1)) {
    return 0;
  }
  const Lexeme word = phrase.token(1);
  phrase.reporter()
      .at(word, support::diagnostics::misspelledKeyword, phrase.text(1), "outage")
      .fix(phrase.source().range(word), "outage");
  phrase.put(phrase.token());
  phrase.put({GliderLexer::OUTAGE, word.begin, word.end});
  return 2;
}

/// `no current`: only of outages it can be said that there are none.
size_t noOther(Phrase& phrase) {
  const bool name = oneOf(phrase.type(1), {GliderLexer::NAME, GliderLexer::CURRENT});
  if (phrase.type() != GliderLexer::NO || !name || phrase.startsLine(1) ||
      phrase.type(2) == GliderLexer::LPAREN) {
    return 0;
  }
  const Lexeme word = phrase.token(1);
  size_t words = 2;  // `no power cuts`
  while (phrase.type(words) == GliderLexer::NAME && !phrase.startsLine(words)) {
    ++words;
  }
  auto report = phrase.reporter().at(word, support::diagnostics::unexpectedToken, "`outage`",
                                     describe(phrase.source(), word));
  report.hint(word.type == GliderLexer::CURRENT
                  ? "write `assume current <= …` with the greatest that there is"
                  : "write `assume no outage`");
  phrase.put(phrase.token());
  phrase.put({GliderLexer::OUTAGE, word.begin, word.end});
  return words;
}

/// `start at home`, `start within 300 m of home`: an area, or a distance from a place.
size_t startAtPlace(Phrase& phrase) {
  const bool start = phrase.type() == GliderLexer::START;
  const bool within = phrase.type(1) == GliderLexer::WITHIN;
  const size_t distance = start && within ? tokensOfQuantity(phrase, 2) : 0;
  const size_t place = within ? 3 + distance : 2;
  const bool words = phrase.type(1) == GliderLexer::AT || phrase.says(1, "near") ||
                     (distance > 0 && phrase.type(place - 1) == GliderLexer::OF);
  if (!start || !words || !isAnyName(phrase.type(place)) || !phrase.startsLine(place + 1)) {
    return 0;
  }
  const Lexeme whole = phrase.whole(1, place, GliderLexer::TRUE);
  const std::string better =
      fmt::format("distance({}) <= {}", phrase.text(place),
                  distance == 0 ? std::string_view("300 m") : phrase.wholeText(2, distance));
  auto report = phrase.reporter().at(phrase.token(1), support::diagnostics::unexpectedToken,
                                     "a condition", describe(phrase.source(), phrase.token(1)));
  if (distance == 0) {
    report.hint(fmt::format("say how near, as in `assume start {}`", better));
  } else {
    report.hint(fmt::format("write `assume start {}`", better))
        .fix(phrase.source().range(whole), better);
  }
  phrase.put(phrase.token());
  phrase.put(whole);
  phrase.notAsMeant();
  return place + 1;
}

/// The tokens of what was written for `<=` from token 1 on, such as `<` and `at most`; a number
/// alone has none.
size_t tokensOfSign(const Phrase& phrase) {
  constexpr std::array<std::string_view, 4> kWords = {"below", "under", "is", "within"};
  constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kPairs = {
      {{"at", "most"}, {"less", "than"}, {"up", "to"}}};
  if (oneOf(phrase.type(1),
            {GliderLexer::LT, GliderLexer::ASSIGN, GliderLexer::EQ, GliderLexer::COLON})) {
    return 1;
  }
  for (const std::string_view word : kWords) {
    if (phrase.says(1, word)) {
      return 1;
    }
  }
  for (const auto& [first, second] : kPairs) {
    if (phrase.says(1, first) && phrase.says(2, second)) {
      return 2;
    }
  }
  return 0;
}

/// `current < 0.2 m/s`, `outage 10 min`: an assumption gives the greatest there is.
size_t greatest(Phrase& phrase) {
  const bool premise =
      oneOf(phrase.type(), {GliderLexer::CURRENT, GliderLexer::OUTAGE}) || isOutages(phrase, 0);
  const size_t sign = premise ? tokensOfSign(phrase) : 0;
  if (!premise || tokensOfNumber(phrase, 1 + sign) == 0 || phrase.isDeclared(phrase.text())) {
    return 0;
  }
  const std::string_view name = phrase.type() == GliderLexer::CURRENT ? "current" : "outage";
  const Lexeme word = phrase.token();
  const Lexeme found = phrase.token(1);
  const uint32_t end = sign == 0 ? word.end : phrase.token(sign).end;
  phrase.reporter()
      .at(found, support::diagnostics::unexpectedToken, "`<=`", describe(phrase.source(), found))
      .hint(fmt::format("write `assume {} <= {}`", name,
                        phrase.wholeText(1 + sign, tokensOfQuantity(phrase, 1 + sign))))
      .fix({phrase.source().file, word.begin, end},
           fmt::format("{} <={}", name, phrase.touches(1 + sign) ? " " : ""));
  phrase.put({name == "current" ? uint32_t{GliderLexer::CURRENT} : uint32_t{GliderLexer::OUTAGE},
              word.begin, word.end});
  phrase.put({GliderLexer::LE, found.begin, end});
  return 1 + sign;
}

}  // namespace

size_t assumption(Phrase& phrase) {
  if (phrase.before() != GliderLexer::ASSUME) {
    return 0;
  }
  return firstOf(phrase, {noOutages, noOther, startAtPlace, greatest});
}

}  // namespace glider::frontend::phrases
