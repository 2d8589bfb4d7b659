// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The values of parameters, read and written. On a board linked only with a mission that has some:
// no_parameters.cpp takes its place otherwise.

#include "runtime/launch/dates.h"
#include "runtime/launch/launch.h"
#include "runtime/launch/quote.h"
#include "runtime/numbers/numbers.h"

#include <string.h>

namespace glider::runtime {
namespace {

Piece whole(const char* text) {
  return {text, text + strlen(text)};
}

/// "m, cm, km"; a plain number's own unit has no name.
void listUnits(const char* list, Text& text) {
  Units units(list);
  for (bool first = true; units.next();) {
    if (!units.name().empty()) {
      text.put(first ? "" : ", ").put(units.name().begin, units.name().size());
      first = false;
    }
  }
}

bool isTime(const char* list) {
  Units units(list);
  return units.next() && units.name().is("s");
}

/// Moves `units` to the first unit of the list; of times to the greatest in which `value` is a
/// whole number: "6 h", not "21600 s". False if the list is empty.
bool chooseUnit(Units& units, bool time, double value) {
  if (!units.next()) {
    return false;
  }
  if (!time) {
    return true;
  }
  constexpr double kMost = 1e15;  // above, every double is a whole number
  for (Units other = units; other.next();) {
    const double count = value / other.factor();
    const bool whole =
        count >= 1 && count < kMost && static_cast<double>(static_cast<int64_t>(count)) == count;
    if (whole && other.factor() > units.factor()) {
      units = other;
    }
  }
  return true;
}

/// Whether a number was written without a unit.
bool isBare(const Piece& given) {
  const char last = given.trimmed().empty() ? ' ' : given.trimmed().end[-1];
  return (last >= '0' && last <= '9') || last == '.';
}

bool isLimited(const GliderParameterInfo& parameter) {
  return isFinite(parameter.lowest) || isFinite(parameter.highest);
}

}  // namespace

void writeQuantity(const GliderParameterInfo& parameter, double value, Text& text) {
  if (isTruth(parameter.units)) {
    text.put(value != 0.0 ? "true" : "false");
    return;
  }
  if (writeDate(parameter, value, text)) {
    return;
  }
  Units units(parameter.units);
  const bool has_unit = chooseUnit(units, isTime(parameter.units), value);
  if (isOnEarth(parameter.units) && value < 0.0) {
    units.next();  // S or W, and no minus
  }
  text.put(has_unit ? value / units.factor() : value);
  if (has_unit && !units.name().empty()) {
    text.put(' ').put(units.name().begin, units.name().size());
  }
}

void writeRange(const GliderParameterInfo& parameter, Text& text) {
  if (!isLimited(parameter) || isTruth(parameter.units)) {
    return;
  }
  const bool from = isFinite(parameter.lowest);
  const bool to = isFinite(parameter.highest);
  if (from) {
    text.put(to ? "" : "at least ");
    writeQuantity(parameter, parameter.lowest, text);
  }
  if (to) {
    text.put(from ? " to " : "at most ");
    writeQuantity(parameter, parameter.highest, text);
  }
}

const char* whyNot(Reading reading) {
  switch (reading) {
    case Reading::TooManyDigits:
      return "more than 15 digits, or too large or small";
    case Reading::SixtyMinutes:
      return "a degree has only 60 minutes";
    case Reading::SignAndLetter:
      return "write a minus sign or a letter, not both";
    case Reading::Good:
    case Reading::NotANumber:
    case Reading::NoSuchUnit:
      break;
  }
  return nullptr;
}

uint32_t Launch::find(const Piece& name) const {
  for (uint32_t i = 0; i < mission_.parameter_count && i < kMostParameters; ++i) {
    const Piece position = positionOf(mission_, i);
    const bool of_position = !name.empty() && position.size() == name.size() &&
                             memcmp(position.begin, name.begin, name.size()) == 0;
    if (of_position || name.is(mission_.parameters[i].name)) {
      return i;
    }
  }
  return kMostParameters;
}

bool Launch::check() {
  // A condition reads nothing but parameters.
  GliderContext context{};
  context.mission = &mission_;
  context.variables = values_;
  const uint32_t failed =
      mission_.condition != nullptr ? mission_.condition(&context) : GLIDER_NO_CASE;
  return failed == GLIDER_NO_CASE || refuseWhere(failed);
}

bool Launch::refuseWhere(uint32_t failed) {
  Text text(problem_, kProblemBytes);
  text.put("the parameters do not satisfy `where` number ").putCount(failed + 1);
  return refuse(text);
}

bool Launch::assign(uint32_t parameter, const Piece& name, const Piece& given) {
  return name.is(mission_.parameters[parameter].name) ? assignOne(parameter, given)
                                                      : assignPosition(parameter, given);
}

void Launch::listNames(Text& text) const {
  for (uint32_t i = 0; i < mission_.parameter_count; ++i) {
    text.put(i == 0 ? "" : ", ");
    if (const Piece position = positionOf(mission_, i); !position.empty()) {
      text.put(position.begin, position.size());
      ++i;
    } else {
      text.put(mission_.parameters[i].name);
    }
  }
}

bool Launch::assignOne(uint32_t parameter, const Piece& given) {
  const GliderParameterInfo& info = mission_.parameters[parameter];
  double value = 0;
  const Reading reading =
      readDate(info, given, value) ? Reading::Good : readQuantity(given, info.units, value);
  if (reading != Reading::Good || !(value >= info.lowest && value <= info.highest)) {
    return refuseValue(info, given, reading, value);
  }
  values_[parameter] = value;
  return true;
}

bool Launch::refuseValue(const GliderParameterInfo& parameter, const Piece& given, Reading reading,
                         double value) {
  Text text(problem_, kProblemBytes);
  quote(text, whole(parameter.name)).put(" cannot be ");
  quote(text, given);
  const bool unread = reading == Reading::NotANumber || reading == Reading::NoSuchUnit;
  if (unread && putDateForm(parameter, text)) {
    return refuse(text);
  }
  switch (reading) {
    case Reading::Good:
      if (isBare(given) && isTime(parameter.units)) {  // 8 for 8 h is easily written
        text.put(", which is ");
        writeQuantity(parameter, value, text);
      }
      text.put(": outside its range, ");
      writeRange(parameter, text);
      break;
    case Reading::TooManyDigits:
    case Reading::SixtyMinutes:
    case Reading::SignAndLetter:
      text.put(": ").put(whyNot(reading));
      break;
    case Reading::NoSuchUnit:
      text.put(": write a value with a unit: ");
      listUnits(parameter.units, text);
      text.put(isOnEarth(parameter.units) ? ", or ddmm.mmmm" : "");
      break;
    case Reading::NotANumber:
      text.put(isTruth(parameter.units) ? ": write `true` or `false`" : ": it is not a number");
      break;
  }
  return refuse(text);
}

}  // namespace glider::runtime
