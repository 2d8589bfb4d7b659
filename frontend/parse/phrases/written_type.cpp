// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/written_type.h"

#include "frontend/parse/token_kinds.h"
#include "frontend/spelling.h"
#include "support/units/units.h"

#include <algorithm>
#include <array>
#include <string>

namespace glider::frontend {
namespace {

/// The tokens of `39.2 N` or `39 10.5 N` from token `k` on; 0: they are something else.
size_t tokensOfHalf(const Phrase& phrase, size_t k) {
  const size_t numbers = phrase.type(k) != GliderLexer::NUMBER       ? 0
                         : phrase.type(k + 1) == GliderLexer::NUMBER ? 2
                                                                     : 1;
  return numbers != 0 && phrase.type(k + numbers) == GliderLexer::COMPASS ? numbers + 1 : 0;
}

}  // namespace

std::string_view typeOfUnit(std::string_view unit) {
  const auto known = support::parseUnit(unit);
  if (!unit.empty() && !known) {
    return "";
  }
#define DIMENSION(name, m, kg, s, a, k, rad, unit_)                     \
  if ((unit.empty() ? support::dimension::number : known->dimension) == \
      support::dimension::name) {                                       \
    return #name;                                                       \
  }
#include "support/units/dimensions.def"
#undef DIMENSION
  return "";
}

std::string_view typeOf(const Phrase& phrase, size_t k) {
  if (oneOf(phrase.type(k), {GliderLexer::TRUE, GliderLexer::FALSE})) {
    return "bool";
  }
  if (const size_t latitude = tokensOfHalf(phrase, k); latitude != 0) {
    return tokensOfHalf(phrase, k + latitude) != 0 ? "position" : "";
  }
  const size_t tokens = tokensOfNumber(phrase, k);
  const size_t number = k + (phrase.type(k) == GliderLexer::MINUS ? 1 : 0);
  if (tokens == 0) {
    return "";
  }
  const size_t next = k + tokens;
  std::string unit;
  for (size_t i = number + 1; i < next; ++i) {
    unit += phrase.text(i);
  }
  if (phrase.type(next) == GliderLexer::DIVIDE && isAnyName(phrase.type(next + 1))) {
    unit += "/" + std::string(phrase.text(next + 1));
  } else if (isOperator(phrase.type(next))) {
    return "";
  }
  return typeOfUnit(unit);
}

namespace {

constexpr std::array kTypes = {
    std::string_view("bool"),
    std::string_view("position"),
#define DIMENSION(name, m, kg, s, a, k, rad, unit) std::string_view(#name),
#include "support/units/dimensions.def"
#undef DIMENSION
};

}  // namespace

bool isTypeName(std::string_view word) {
  return std::ranges::find(kTypes, word) != kTypes.end();
}

std::string_view nearTypeName(std::string_view word) {
  return closest(word, {kTypes.begin(), kTypes.end()});
}

}  // namespace glider::frontend
