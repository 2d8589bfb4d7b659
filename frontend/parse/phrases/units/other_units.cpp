// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Units of other systems, with what takes their place.

#include "frontend/bare_positions.h"
#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"
#include "frontend/spelling.h"
#include "support/diagnostics/ids/syntax.h"
#include "support/units/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::frontend::phrases {
namespace {

/// A unit of another system, with the unit of the language that takes its place: a value of `v`
/// is `v * factor + offset` there.
struct OtherUnit {
  std::string_view unit;  ///< in lower case
  std::string_view ours;  ///< empty: readings in it are plain numbers
  double factor;
  double offset;
  bool same = false;  ///< another name of our unit: certain enough for a fix
  /// What our unit stands for, if the other may mean something else too.
  std::string_view only_if = "";
  std::string_view otherwise = "";  ///< our unit for that
  double other_factor = 0;
  std::string_view other_if = "if not";
};
constexpr double kOxygen_uM_per_mg = 31.25;  // 32 g/mol
constexpr double kOxygen_uM_per_ml = 44.66;  // of an ideal gas at 0 degC
constexpr double kSeaWater_kg_per_l = 1.025;
constexpr std::string_view kOxygen = "if it is oxygen";
constexpr OtherUnit kOtherUnits[] = {
    {"degf", "degC", 1 / 1.8, -32 / 1.8},
    {"fahrenheit", "degC", 1 / 1.8, -32 / 1.8},
    {"f", "degC", 1 / 1.8, -32 / 1.8},
    {"kelvin", "degC", 1, -273.15},
    {"k", "degC", 1, -273.15},
    {"hpa", "bar", 0.001, 0},
    {"mbar", "bar", 0.001, 0},
    {"kpa", "bar", 0.01, 0},
    {"psi", "bar", 0.0689476, 0},
    {"atm", "bar", 1.01325, 0},
    {"ms", "s", 0.001, 0},
    {"week", "day", 7, 0},
    {"weeks", "day", 7, 0},
    {"month", "day", 30, 0},
    {"months", "day", 30, 0},
    {"year", "day", 365, 0},
    {"years", "day", 365, 0},
    {"ms/cm", "S/m", 0.1, 0},
    {"us/cm", "S/m", 0.0001, 0},
    {"km/h", "m/s", 1 / 3.6, 0},
    {"kmh", "m/s", 1 / 3.6, 0},
    {"kph", "m/s", 1 / 3.6, 0},
    {"mph", "m/s", 0.44704, 0},
    {"fathom", "m", 1.8288, 0},
    {"fathoms", "m", 1.8288, 0},
    {"yard", "m", 0.9144, 0},
    {"yards", "m", 0.9144, 0},
    {"yd", "m", 0.9144, 0},
    {"yds", "m", 0.9144, 0},
    {"mile", "km", 1.609344, 0, false, "for land miles", "nmi", 1, "for nautical miles"},
    {"miles", "km", 1.609344, 0, false, "for land miles", "nmi", 1, "for nautical miles"},
    {"mi", "km", 1.609344, 0, false, "for land miles", "nmi", 1, "for nautical miles"},
    {"mv", "V", 0.001, 0},
    {"millivolt", "V", 0.001, 0},
    {"millivolts", "V", 0.001, 0},
    {"mj", "J", 0.001, 0, false, "for thousandths of a joule", "MJ", 1, "for megajoules"},
    {"um", "uM", 1, 0},
    {"umol", "uM", 1, 0},
    {"umol/kg", "uM", kSeaWater_kg_per_l, 0},
    {"umol/l", "uM", 1, 0, true},
    {"mmol/m3", "uM", 1, 0, true},
    {"ug/l", "ug/L", 1, 0, true},
    {"mg/m3", "ug/L", 1, 0, true},
    {"magnetic", "deg magnetic", 1, 0},
    {"mg/l", "uM", kOxygen_uM_per_mg, 0, false, kOxygen, "ug/L", 1000},
    {"ml/l", "uM", kOxygen_uM_per_ml, 0, false, kOxygen},
    {"psu", "", 0, 0, true},
    {"ppb", "", 0, 0},
    {"inches", "inch", 1, 0, true},
    {"ccm", "cc", 1, 0, true},
    {"cm3", "cc", 1, 0, true},
    {"litre", "cc", 1000, 0},
    {"litres", "cc", 1000, 0},
    {"liter", "cc", 1000, 0},
    {"liters", "cc", 1000, 0}};

const OtherUnit* otherUnit(std::string unit) {
  std::ranges::transform(unit, unit.begin(), [](unsigned char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : static_cast<char>(c);
  });
  const auto* row = std::ranges::find(kOtherUnits, unit, &OtherUnit::unit);
  return row == std::end(kOtherUnits) ? nullptr : row;
}

/// The number before the current token, with its sign.
double numberBefore(const Phrase& phrase) {
  const bool negative = phrase.before(1) == GliderLexer::MINUS && !endsValue(phrase.before(2));
  const double number = valueOf(phrase.source().text(*phrase.lexemeBefore()));
  return negative ? -number : number;
}

/// What is compared with the number before the current token, `depth > 5`; empty: that is not
/// known.
std::string_view comparedName(const Phrase& phrase) {
  const bool compares =
      oneOf(phrase.before(1), {GliderLexer::LT, GliderLexer::GT, GliderLexer::LE, GliderLexer::GE});
  return compares && isName(phrase.before(2)) ? phrase.source().text(*phrase.lexemeBefore(2))
                                              : std::string_view();
}

bool isClockName(std::string_view name) {
  return name == "statetime" || name == "missiontime" || name == "resumetime";
}

/// `10k`: the word of thousands of metres, where no temperature is compared.
bool isThousands(const Phrase& phrase, std::string_view unit) {
  return unit == "k" && comparedName(phrase) != "temp";
}

/// What to write for a number in `other`; nullptr: in a unit of no system.
std::string insteadOfUnit(const Phrase& phrase, const OtherUnit* other, std::string_view written) {
  const double number = numberBefore(phrase);
  if (isThousands(phrase, written)) {
    return fmt::format("write `{0:.6g} km`, or `{1:.10g}` if it has no unit", number,
                       1000 * number);
  }
  if (other == nullptr || other->ours.empty()) {
    return "write the number alone: readings of sensors without a unit here are plain numbers";
  }
  // Few seas are that cold: below, it is a difference.
  constexpr double kColdest_K = 200;
  if (other->offset < -kColdest_K && std::fabs(number) < kColdest_K) {
    return fmt::format("write `{:.4g} degC`: a difference has the same unit", number);
  }
  std::string hint =
      fmt::format("write `{:.4g} {}`", number * other->factor + other->offset, other->ours);
  hint += other->only_if.empty() ? "" : fmt::format(" {}", other->only_if);
  hint += other->otherwise.empty() ? ""
                                   : fmt::format(", `{:.6g} {}` {}", number * other->other_factor,
                                                 other->otherwise, other->other_if);
  return hint;
}

}  // namespace

size_t millilitresPerLitre(Phrase& phrase) {
  const bool written = phrase.before() == GliderLexer::NUMBER && phrase.says(0, "ml") &&
                       phrase.type(1) == GliderLexer::DIVIDE && phrase.says(2, "l") &&
                       phrase.touches(1) && phrase.touches(2);
  if (!written) {
    return 0;
  }
  phrase.reporter().at(phrase.whole(0, 3), support::diagnostics::unknownUnit,
                       phrase.wholeText(0, 3), insteadOfUnit(phrase, otherUnit("ml/l"), "ml/l"));
  phrase.notAsMeant();
  return 3;
}

size_t perUnit(Phrase& phrase) {
  const bool number = oneOf(phrase.before(), {GliderLexer::UNIT, GliderLexer::MIN}) &&
                      phrase.before(1) == GliderLexer::NUMBER;
  if (!number || !phrase.says(0, "per") || phrase.startsLine() || phrase.startsLine(1) ||
      !isAnyName(phrase.type(1))) {
    return 0;
  }
  const Lexeme unit = *phrase.lexemeBefore();
  const std::string_view word = phrase.text(1);
  const std::string_view other = support::findUnit(word) ? word : unitForWord(word);
  const std::string better = fmt::format("{}/{}", phrase.source().text(unit), other);
  if (other.empty() || !support::parseUnit(better)) {
    return 0;
  }
  const Lexeme both = phrase.whole(0, 2);
  phrase.reporter()
      .at(phrase.token(), support::diagnostics::wordOperator, phrase.text(), "/")
      .hint(fmt::format("write `{} {}`", phrase.source().text(*phrase.lexemeBefore(1)), better))
      .fix({phrase.source().file, unit.end, both.end}, fmt::format("/{}", other));
  phrase.notAsMeant();  // the number has only the first of the two units
  return 2;
}

size_t signOfFeet(Phrase& phrase) {
  const bool number = phrase.before() == GliderLexer::NUMBER && phrase.touches(0);
  if (phrase.text() != "'" || !number || phrase.keyword() == GliderLexer::LOG ||
      oneOf(phrase.type(1), {GliderLexer::COMPASS, GliderLexer::NUMBER, GliderLexer::FOREIGN})) {
    return 0;
  }
  const std::string_view name = comparedName(phrase);
  const std::string_view value = phrase.source().text(*phrase.lexemeBefore());
  const std::string hint =
      isClockName(name) ? fmt::format("write `{} min`", value)
      : !name.empty()   ? fmt::format("write `{} ft`", value)
                        : fmt::format("write `{0} ft` for feet, `{0} min` for minutes", value);
  phrase.reporter().at(phrase.token(), support::diagnostics::unknownUnit, phrase.text(), hint);
  phrase.notAsMeant();
  return 1;
}

namespace {

/// The `^3` of `kg/m^3`, the `³` of `kg/m³`, at token `k`.
size_t tokensOfPower(const Phrase& phrase, size_t k) {
  if (phrase.type(k) != GliderLexer::FOREIGN || !phrase.touches(k)) {
    return 0;
  }
  if (phrase.text(k) != "^") {
    return phrase.text(k) == "²" || phrase.text(k) == "³" ? 1 : 0;
  }
  const size_t sign = phrase.type(k + 1) == GliderLexer::MINUS ? 1 : 0;
  return phrase.type(k + 1 + sign) == GliderLexer::NUMBER ? 2 + sign : 0;
}

bool isMicroSign(std::string_view text) {
  return text == "\xC2\xB5" || text == "\xCE\xBC";  // U+00B5, U+03BC
}

/// `2 µg/L`: a unit of the language, with a micro sign in it.
size_t microUnit(Phrase& phrase) {
  if (phrase.before() != GliderLexer::NUMBER || !isMicroSign(phrase.text()) || !phrase.touches(1)) {
    return 0;
  }
  for (const size_t tokens : {4U, 2U}) {
    const Lexeme unit = phrase.whole(0, tokens, GliderLexer::UNIT);
    std::string better(phrase.source().text(unit));
    better.replace(0, phrase.text().size(), "u");
    if (better == "ug/l") {
      better = "ug/L";
    }
    if (support::findUnit(better)) {
      const bool apart = phrase.lexemeBefore()->end < unit.begin;
      phrase.reporter()
          .at(unit, support::diagnostics::unknownUnit, phrase.source().text(unit),
              fmt::format("write `{}`", better))
          .fix(phrase.source().range(unit), (apart ? "" : " ") + better);
      return tokens;
    }
  }
  return 0;
}

/// `5 nautical miles`.
size_t nauticalMiles(Phrase& phrase) {
  if (phrase.before() != GliderLexer::NUMBER || !phrase.says(0, "nautical") ||
      !(phrase.says(1, "miles") || phrase.says(1, "mile"))) {
    return 0;
  }
  const Lexeme unit = phrase.whole(0, 2);
  phrase.reporter()
      .at(unit, support::diagnostics::unknownUnit, phrase.source().text(unit), "write `nmi`")
      .fix(phrase.source().range(unit), "nmi");
  phrase.notAsMeant();
  return 2;
}

}  // namespace

size_t foreignUnit(Phrase& phrase) {
  if (const size_t taken = firstOf(phrase, {microUnit, nauticalMiles})) {
    return taken;
  }
  if (phrase.before() != GliderLexer::NUMBER || phrase.startsLine()) {
    return 0;
  }
  const size_t micro = isMicroSign(phrase.text()) && phrase.touches(1) ? 1 : 0;
  if (micro == 0 ? phrase.type() != GliderLexer::NAME : !isAnyName(phrase.type(1))) {
    return 0;
  }
  const bool fraction = phrase.type(micro + 1) == GliderLexer::DIVIDE &&
                        isAnyName(phrase.type(micro + 2)) && phrase.touches(micro + 1) &&
                        phrase.touches(micro + 2);
  const size_t name = micro + (fraction ? 3 : 1);
  const size_t tokens = name + tokensOfPower(phrase, name);
  std::string written(phrase.wholeText(0, tokens));
  if (micro == 1) {
    written.replace(0, phrase.text().size(), "u");
  }
  const OtherUnit* other = otherUnit(written);
  if (other == nullptr && micro == 0 && !(fraction && unitForWord(phrase.text()).empty())) {
    return 0;
  }
  const Lexeme unit = phrase.whole(0, tokens, GliderLexer::UNIT);
  auto report =
      phrase.reporter().at(unit, support::diagnostics::unknownUnit, phrase.source().text(unit),
                           insteadOfUnit(phrase, other, written));
  if (other != nullptr && other->ours.empty() && other->same) {
    report.fix({phrase.source().file, phrase.lexemeBefore()->end, unit.end}, "");
  } else if (other != nullptr && other->same) {
    const bool apart = phrase.lexemeBefore()->end < unit.begin;
    report.fix(phrase.source().range(unit), (apart ? "" : " ") + std::string(other->ours));
  } else if (phrase.keyword() == GliderLexer::SAMPLE) {
    phrase.notAsMeant();  // nothing is said of how often 500 is
  }
  return tokens;
}

}  // namespace glider::frontend::phrases
