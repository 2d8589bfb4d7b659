// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/samples/sample_parts.h"

#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

namespace glider::frontend::phrases {
namespace {

/// Whether it leads a part, so that what follows belongs to it.
bool leads(uint32_t type) {
  return oneOf(type, {GliderLexer::ON, GliderLexer::BELOW, GliderLexer::ABOVE, GliderLexer::WHEN,
                      GliderLexer::ONE, GliderLexer::IN, GliderLexer::WITHIN});
}

/// Its words, where they are not known to be such: `sample: ctd off`.
size_t wordOfSample(Phrase& phrase) {
  struct Word {
    std::string_view text;
    uint32_t type;
  };
  constexpr Word kWords[] = {{"off", GliderLexer::OFF},       {"on", GliderLexer::ON},
                             {"climbs", GliderLexer::CLIMBS}, {"dives", GliderLexer::DIVES},
                             {"below", GliderLexer::BELOW},   {"above", GliderLexer::ABOVE},
                             {"one", GliderLexer::ONE}};
  if (phrase.type() != GliderLexer::NAME || !mayBeginPart(phrase)) {
    const bool way = phrase.before() == GliderLexer::ON && phrase.type() == GliderLexer::NAME;
    const bool yo = phrase.before() == GliderLexer::ONE && phrase.text() == "yo";
    if (!way && !yo) {
      return 0;
    }
    if (yo) {
      phrase.put({GliderLexer::YO, phrase.token().begin, phrase.token().end});
      return 1;
    }
  }
  for (const Word& word : kWords) {
    if (phrase.text() == word.text) {
      phrase.put({word.type, phrase.token().begin, phrase.token().end});
      return 1;
    }
  }
  return 0;
}

}  // namespace

SampleItem sampleItem(const Phrase& phrase) {
  SampleItem item;
  size_t deep = 0;
  for (size_t k = 0; phrase.before(k) != 0 && phrase.before(k) != GliderLexer::SAMPLE; ++k) {
    const uint32_t type = phrase.before(k);
    deep += type == GliderLexer::RPAREN ? 1U : 0U;
    deep -= type == GliderLexer::LPAREN ? 1U : 0U;
    if (deep == 0 && type == GliderLexer::COMMA) {
      break;
    }
    item.tokens = k + 1;
    item.often = item.often || oneOf(type, {GliderLexer::OFF, GliderLexer::EVERY});
    const bool part = oneOf(type, {GliderLexer::ON, GliderLexer::BELOW, GliderLexer::ABOVE,
                                   GliderLexer::WHEN, GliderLexer::ONE});
    item.when = part ? k + 1 : item.when;
  }
  return item;
}

bool afterInstrument(const Phrase& phrase) {
  return isAnyName(phrase.before()) &&
         oneOf(phrase.before(1), {GliderLexer::SAMPLE, GliderLexer::COMMA});
}

bool mayBeginPart(const Phrase& phrase) {
  return afterInstrument(phrase) || (endsValue(phrase.before()) && !leads(phrase.before()));
}

bool beginsPart(const Phrase& phrase, size_t k) {
  return phrase.type(k) == GliderLexer::EVERY ||
         tokensOfOne(phrase, k, {"off", "on", "below", "above", "one", "when"}) > 0;
}

bool endsSample(const Phrase& phrase, size_t k) {
  const uint32_t type = phrase.type(k);
  return type == kEof || type == GliderLexer::VAR || startsMember(type) ||
         type == GliderLexer::END || startsItem(type);
}

std::string_view readText(const Phrase& phrase, size_t back) {
  return phrase.source().text(
      {0, phrase.lexemeBefore(back - 1)->begin, phrase.lexemeBefore()->end});
}

void reportMeant(Phrase& phrase, size_t count, std::string_view better) {
  const Lexeme written = phrase.whole(0, count);
  phrase.reporter()
      .at(written, support::diagnostics::unexpectedToken, fmt::format("`{}`", better),
          fmt::format("`{}`", phrase.source().text(written)))
      .hint(fmt::format("write `{}`", better))
      .fix(phrase.source().range(written), std::string(better));
}

size_t leaveOutWords(Phrase& phrase, size_t count, std::string_view where) {
  const Lexeme written = phrase.whole(0, count);
  const uint32_t from = phrase.lexemeBefore() == nullptr || phrase.startsLine()
                            ? written.begin
                            : phrase.lexemeBefore()->end;
  phrase.reporter()
      .at(written, support::diagnostics::superfluousWord, phrase.source().text(written), where)
      .fix({phrase.source().file, from, written.end},
           phrase.touches(count) && isAnyName(phrase.type(count)) ? " " : "");
  return count;
}

size_t sample(Phrase& phrase) {
  if (const size_t taken = sampleHead(phrase)) {
    return taken;
  }
  const bool always = phrase.type() == GliderLexer::ALWAYS && !phrase.startsLine();
  if (phrase.keyword() != GliderLexer::SAMPLE || !phrase.open().empty() ||
      (endsSample(phrase, 0) && !always)) {
    return 0;
  }
  return firstOf(phrase, {partBeforeInstrument, someYos, wayOfVehicle, sampleDepth, sampleRate,
                          partOrder, sampleCondition, wordOfInstrument, sampleComma, wordOfSample});
}

}  // namespace glider::frontend::phrases
