// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/phrases/phrase.h"

#include <string>
#include <string_view>

/// The errors in `sample …` of a state, by what they are about. Each repair looks at one part, at
/// the token where that begins; what it leaves alone is right, or another's.
namespace glider::frontend::phrases {

/// What was read of an instrument and how it reads, up to the current token.
struct SampleItem {
  size_t tokens = 0;   ///< with the name of the instrument
  bool often = false;  ///< it has `off` or `every …`
  size_t when = 0;     ///< the tokens from the first `on`, `below`, `when`, … on; 0: there is none
};

SampleItem sampleItem(const Phrase& phrase);

/// Whether the current token follows an instrument.
bool afterInstrument(const Phrase& phrase);
/// Whether it follows an instrument or a whole part, so that a part may begin with it.
bool mayBeginPart(const Phrase& phrase);
/// Whether what begins with token `k` says how an instrument reads.
bool beginsPart(const Phrase& phrase, size_t k);
/// Whether `sample` ends before token `k`.
bool endsSample(const Phrase& phrase, size_t k);

/// What was read of the item, from its tokens `back` ago up to the current token, as written.
std::string_view readText(const Phrase& phrase, size_t back);

/// Reports that `better` was meant by `count` tokens, and nothing else.
void reportMeant(Phrase& phrase, size_t count, std::string_view better);
/// Reports that these tokens say nothing, `where`: they are left out.
size_t leaveOutWords(Phrase& phrase, size_t count, std::string_view where);

/// `sample: ctd …`, `samples ctd …`, `sample` alone.
size_t sampleHead(Phrase& phrase);
/// `off optode`, `turn off optode`, `every 4 s ctd`, `the ctd`.
size_t partBeforeInstrument(Phrase& phrase);
/// `ctd 4 s`, `ctd at 0.25 Hz`, `ctd each 4 s`.
size_t sampleRate(Phrase& phrase);
/// `ctd on climbs every 4 s`.
size_t partOrder(Phrase& phrase);
/// `every third yo`, `one in 3`, `one yo of 3`.
size_t someYos(Phrase& phrase);
/// `on climb`, `while diving`, `on dives and climbs`, `on climbs only`.
size_t wayOfVehicle(Phrase& phrase);
/// `deeper than 10 m`, `between 10 m and 20 m`.
size_t sampleDepth(Phrase& phrase);
/// `if depth > 10 m`, `for 10 min`, `after 1 h`.
size_t sampleCondition(Phrase& phrase);
/// `ctd on`, `ctd always`, `ctd never`, `ctd: off`, `ctd (off)`.
size_t wordOfInstrument(Phrase& phrase);
/// `ctd and optode`, `ctd off optode off`, `ctd off; optode off`.
size_t sampleComma(Phrase& phrase);

}  // namespace glider::frontend::phrases
