// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/samples/sample_parts.h"
#include "frontend/parse/token_kinds.h"
#include "frontend/spelling.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

// How `sample …` begins, and what pilots write before the name of an instrument.

namespace glider::frontend::phrases {
namespace {

/// Whether a member of a state begins here, or the next sensor after a comma that is missing.
bool mayBeginMember(const Phrase& phrase) {
  return phrase.startsLine() && phrase.open().empty() &&
         (endsValue(phrase.before()) || phrase.before() == GliderLexer::BEGIN) &&
         oneOf(phrase.keyword(), {GliderLexer::FLIGHTPROFILE, GliderLexer::FLIGHTROUTE,
                                  GliderLexer::SENSORS, GliderLexer::BEGIN});
}

/// The tokens of `off`, `turn off the` before an instrument at token `k`.
size_t tokensOfSwitch(const Phrase& phrase, size_t k) {
  const size_t words = tokensOfOne(
      phrase, k, {"turn off", "switch off", "no", "without", "disable", "never", "off"});
  return words == 0 ? 0 : words + tokensOfOne(phrase, k + words, {"the"});
}

/// The tokens of `every 4 s` from token `k` on.
size_t tokensOfEvery(const Phrase& phrase, size_t k) {
  const size_t time = phrase.type(k) == GliderLexer::EVERY ? tokensOfQuantity(phrase, k + 1) : 0;
  return time > 1 ? time + 1 : 0;
}

/// Whether token `k`, and no other after it, can be an instrument.
bool lastInstrument(const Phrase& phrase, size_t k) {
  return isAnyName(phrase.type(k)) && !phrase.startsLine(k) &&
         (phrase.startsLine(k + 1) || phrase.type(k + 1) == GliderLexer::COMMA);
}

/// `every 4 s ctd`: the part that begins with token `k`, before its instrument.
size_t tokensBefore(const Phrase& phrase, size_t k) {
  const size_t off = tokensOfSwitch(phrase, k);
  const size_t part = off > 0 ? off : tokensOfEvery(phrase, k);
  return part > 0 && lastInstrument(phrase, k + part) ? part : 0;
}

/// Whether the line says how often instruments read.
bool saysHowOften(const Phrase& phrase) {
  const size_t line = phrase.tokensOfLine();
  for (size_t k = 2; k < line; ++k) {
    if (tokensOfOne(phrase, k, {"every", "off", "on climbs", "on dives", "one yo"}) > 0) {
      return true;
    }
  }
  return false;
}

void putSample(Phrase& phrase) {
  phrase.put({GliderLexer::SAMPLE, phrase.token().begin, phrase.token().end});
}

/// `sample:`, `sample =`.
size_t signAfterSample(Phrase& phrase) {
  const bool sign = oneOf(phrase.type(1), {GliderLexer::COLON, GliderLexer::ASSIGN});
  if (!sign || !isAnyName(phrase.type(2)) || phrase.startsLine(1) || phrase.startsLine(2)) {
    return 0;
  }
  phrase.reporter()
      .at(phrase.token(1), support::diagnostics::superfluousWord, phrase.text(1), "after `sample`")
      .fix(phrase.source().range(phrase.token(1)), "");
  putSample(phrase);
  return 2;
}

/// `sample` and the next line.
size_t nothingSampled(Phrase& phrase) {
  if (!endsSample(phrase, 1)) {
    return 0;
  }
  phrase.reporter()
      .at(phrase.token(), support::diagnostics::unexpectedToken, "an instrument after `sample`",
          describe(phrase.source(), phrase.token(1)))
      .hint("write which instruments read how often, as in `sample ctd every 4 s, optode off`");
  phrase.notAsMeant();
  return 1;
}

/// `samples ctd …`, `instruments ctd …`, `switch ctd off`.
size_t wordForSample(Phrase& phrase) {
  const bool other = tokensOfOne(phrase, 0,
                                 {"samples", "sampling", "sampled", "instrument", "instruments",
                                  "switch", "turn", "measure", "read"}) > 0 ||
                     editDistance(phrase.lower(), "sample") == 1;
  if (!other || !isAnyName(phrase.type(1)) || phrase.startsLine(1) || !saysHowOften(phrase)) {
    return 0;
  }
  const bool logs = tokensOfOne(phrase, 0, {"measure", "read"}) > 0;
  auto report = phrase.reporter().at(phrase.token(), support::diagnostics::misspelledKeyword,
                                     phrase.text(), "sample");
  if (logs) {
    report.hint("write `sample` for how often instruments read, `sensors` for what is logged");
    phrase.notAsMeant();
  } else {
    report.fix(phrase.source().range(phrase.token()), "sample");
  }
  putSample(phrase);
  return 1;
}

}  // namespace

size_t sampleHead(Phrase& phrase) {
  if (phrase.type() != GliderLexer::NAME || !mayBeginMember(phrase)) {
    return 0;
  }
  if (phrase.text() != "sample") {
    return wordForSample(phrase);
  }
  if (tokensBefore(phrase, 1) > 0 && !phrase.startsLine(1)) {
    putSample(phrase);  // the next repair reports it
    return 1;
  }
  return firstOf(phrase, {signAfterSample, nothingSampled});
}

namespace {

/// `all instruments`: one name, of which is said later what to write.
size_t allInstruments(Phrase& phrase) {
  const size_t words = tokensOfOne(
      phrase, 0, {"all the instruments", "all instruments", "all sensors", "every instrument"});
  if (words > 0) {
    phrase.put(phrase.whole(0, words, GliderLexer::NAME));
  }
  return words;
}

}  // namespace

size_t partBeforeInstrument(Phrase& phrase) {
  if (!oneOf(phrase.before(), {GliderLexer::SAMPLE, GliderLexer::COMMA})) {
    return 0;
  }
  if (const size_t words = allInstruments(phrase)) {
    return words;
  }
  const size_t part = tokensBefore(phrase, 0);
  if (part == 0) {
    const size_t words = tokensOfOne(
        phrase, 0, {"turn on the", "turn on", "switch on", "enable", "only the", "the"});
    return words > 0 && isAnyName(phrase.type(words)) && !phrase.startsLine(words)
               ? leaveOutWords(phrase, words, "before an instrument")
               : 0;
  }
  const bool off = phrase.type() != GliderLexer::EVERY;
  const std::string_view often = off ? std::string_view("off") : phrase.wholeText(0, part);
  const std::string better = fmt::format("{} {}", phrase.text(part), often);
  const std::string_view written = phrase.wholeText(0, part);
  phrase.reporter()
      .at(phrase.whole(0, part), support::diagnostics::headerOrder, written,
          fmt::format("after `{}`", phrase.text(part)))
      .hint(fmt::format("write `{}`", better))
      .fix(phrase.source().range(phrase.whole(0, part + 1)), better);
  phrase.put({GliderLexer::NAME, phrase.token(part).begin, phrase.token(part).end});
  if (off) {
    phrase.put({GliderLexer::OFF, phrase.token().begin, phrase.token().end});
  } else {
    for (size_t k = 0; k < part; ++k) {
      phrase.put(phrase.token(k));
    }
  }
  return part + 1;
}

}  // namespace glider::frontend::phrases
