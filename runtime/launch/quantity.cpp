// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/launch/quantity.h"

#include "runtime/abi/glider_abi.h"
#include "runtime/numbers/numbers.h"

#include <string.h>

namespace glider::runtime {
namespace {

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

bool isLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// The last character that is not white space; 0: there is none.
char lastOf(const Piece& text) {
  const Piece piece = text.trimmed();
  return piece.empty() ? '\0' : piece.end[-1];
}

uint64_t hexadecimal(const char* digits, uint32_t count) {
  uint64_t value = 0;
  for (uint32_t i = 0; i < count; ++i) {
    const char c = digits[i];
    value = value << 4U | static_cast<uint64_t>(isDigit(c) ? c - '0' : c - 'a' + 10);
  }
  return value;
}

/// A decimal number, exactly: digits * 10^exponent.
struct Decimal {
  bool negative = false;
  double digits = 0;  ///< a whole number, exact up to kMostDigits digits
  int32_t exponent = 0;
  uint32_t seen = 0;         ///< digits of all kinds
  uint32_t whole = 0;        ///< of them, before the point
  uint32_t significant = 0;  ///< without leading zeros
};

constexpr uint32_t kMostDigits = 15;
constexpr int32_t kMostPower = 22;
constexpr int32_t kMostExponent = 1000;

void takeDigits(Piece& text, Decimal& number, bool fraction) {
  for (; !text.empty() && isDigit(*text.begin); ++text.begin) {
    ++number.seen;
    if (number.significant > 0 || *text.begin != '0') {
      ++number.significant;
    }
    if (number.significant <= kMostDigits) {
      number.digits = number.digits * 10.0 + static_cast<double>(*text.begin - '0');
      number.exponent -= fraction ? 1 : 0;
    }
  }
}

bool takeSign(Piece& text) {
  const bool negative = !text.empty() && *text.begin == '-';
  if (negative || (!text.empty() && *text.begin == '+')) {
    ++text.begin;
  }
  return negative;
}

/// "e-3"; anything else after a number is its unit.
void takeExponent(Piece& text, Decimal& number) {
  Piece rest = text;
  if (rest.empty() || (*rest.begin != 'e' && *rest.begin != 'E')) {
    return;
  }
  ++rest.begin;
  const bool negative = takeSign(rest);
  if (rest.empty() || !isDigit(*rest.begin)) {
    return;
  }
  int32_t exponent = 0;
  for (; !rest.empty() && isDigit(*rest.begin); ++rest.begin) {
    exponent = exponent < kMostExponent ? exponent * 10 + (*rest.begin - '0') : exponent;
  }
  number.exponent += negative ? -exponent : exponent;
  text = rest;
}

Decimal takeDecimal(Piece& text) {
  Decimal number;
  number.negative = takeSign(text);
  takeDigits(text, number, false);
  number.whole = number.seen;
  if (!text.empty() && *text.begin == '.') {
    ++text.begin;
    takeDigits(text, number, true);
  }
  if (number.seen > 0) {
    takeExponent(text, number);
  }
  return number;
}

/// False if a single operation cannot give the nearest double.
bool toDouble(const Decimal& number, double& value) {
  if (number.significant == 0) {
    value = 0;
    return true;
  }
  const int32_t size = number.exponent < 0 ? -number.exponent : number.exponent;
  if (number.significant > kMostDigits || size > kMostPower) {
    return false;
  }
  double power = 1;  // exact up to 10^22
  for (int32_t i = 0; i < size; ++i) {
    power *= 10.0;
  }
  value = gliderSettle(number.exponent < 0 ? number.digits / power : number.digits * power);
  value = number.negative ? negated(value) : value;
  return true;
}

/// Turns `value`, ddmm.mmmm, into degrees. Three digits or more before the point distinguish it
/// from decimal degrees.
Reading fromDdmm(const Decimal& number, double& value) {
  constexpr uint32_t kFewest = 3;
  constexpr uint32_t kMost = 5;
  if (number.significant == 0) {
    return Reading::Good;
  }
  if (number.whole < kFewest || number.whole > kMost || number.exponent > 0) {
    return Reading::NoSuchUnit;
  }
  const double degrees = static_cast<int32_t>(value / 100.0);
  const double minutes = value - degrees * 100.0;
  value = degrees + minutes / 60.0;
  return minutes < 60.0 && minutes > -60.0 ? Reading::Good : Reading::SixtyMinutes;
}

/// Turns `39 10.5 N` into degrees: a whole number, then minutes below 60. Takes the minutes from
/// `text`.
Reading addMinutes(Piece& text, const Decimal& degrees, double& value) {
  const Decimal minutes = takeDecimal(text);
  double plain = 0;
  if (!toDouble(minutes, plain)) {
    return Reading::TooManyDigits;
  }
  if (degrees.seen != degrees.whole || degrees.exponent != 0 || minutes.negative) {
    return Reading::NoSuchUnit;
  }
  if (!(plain < 60.0)) {
    return Reading::SixtyMinutes;
  }
  value = gliderSettle(value + plain / 60.0);
  return Reading::Good;
}

bool factorOf(const Piece& unit, const char* units, double& factor) {
  Units known(units);
  for (bool first = true; known.next(); first = false) {
    const bool same = known.name().size() == unit.size() &&
                      memcmp(known.name().begin, unit.begin, unit.size()) == 0;
    if (same || (first && unit.empty())) {
      factor = known.factor();
      return true;
    }
  }
  return false;
}

/// A latitude or a longitude.
Reading readHalf(Piece rest, const char* units, double& value) {
  constexpr uint32_t kFewestDdmm = 4;  // 139.5 E is decimal degrees
  const Decimal number = takeDecimal(rest);
  if (number.seen == 0) {
    return Reading::NotANumber;
  }
  double degrees = 0;
  if (!toDouble(number, degrees)) {
    return Reading::TooManyDigits;
  }
  rest = rest.trimmed();
  if (rest.empty()) {
    value = degrees;
    return fromDdmm(number, value);
  }
  Reading reading = Reading::Good;
  if (isDigit(*rest.begin) || *rest.begin == '.') {
    reading = addMinutes(rest, number, degrees);
    rest = rest.trimmed();
  } else if (number.whole >= kFewestDdmm) {
    reading = fromDdmm(number, degrees);
  }
  if (reading != Reading::Good) {
    return reading;
  }
  double side = 1;
  if (rest.empty() || !factorOf(rest, units, side)) {
    return Reading::NoSuchUnit;
  }
  if (number.negative) {
    return Reading::SignAndLetter;
  }
  value = gliderSettle(degrees * side);
  return Reading::Good;
}

/// One number with its unit; `factor` is that of the unit.
Reading readPart(Piece text, const char* units, double& value, double& factor) {
  const Decimal number = takeDecimal(text);
  if (number.seen == 0) {
    return Reading::NotANumber;
  }
  if (!factorOf(text.trimmed(), units, factor)) {
    return Reading::NoSuchUnit;
  }
  double plain = 0;
  if (!toDouble(number, plain)) {
    return Reading::TooManyDigits;
  }
  value = gliderSettle(plain * factor);
  return Reading::Good;
}

/// Whether the unit of a time ends with it; `1e3 s` has none before the 3.
bool endsUnit(char c) {
  return isLetter(c) && c != 'e' && c != 'E';
}

/// Takes `3 h` from `3 h 30 min`: up to the first digit after a unit.
Piece takePart(Piece& text) {
  const char* end = text.begin;
  while (end != text.end && !(isDigit(*end) && endsUnit(lastOf({text.begin, end})))) {
    ++end;
  }
  const Piece part = Piece{text.begin, end}.trimmed();
  text = Piece{end, text.end}.trimmed();
  return part;
}

/// `3 h 30 min`, as in the language: from the largest unit to the smallest, and each part less than
/// the unit before it.
Reading readDuration(Piece rest, const char* units, double& value) {
  double sum = 0;
  double last = 0;
  for (bool first = true; first || !rest.empty(); first = false) {
    const Piece part = takePart(rest);
    double time = 0;
    double unit = 1;
    const Reading reading = readPart(part, units, time, unit);
    if (reading != Reading::Good) {
      return reading;
    }
    const bool bare = !isLetter(lastOf(part));
    const bool more = !rest.empty();
    if ((!first && (bare || !(unit < last) || !(time < last))) || (more && (bare || time < 0.0))) {
      return Reading::NoSuchUnit;
    }
    sum = gliderSettle(sum + time);
    last = unit;
  }
  value = sum;
  return Reading::Good;
}

Reading readNumber(Piece rest, const char* units, double& value) {
  double factor = 1;
  Units known(units);
  const bool time = known.next() && known.name().is("s");
  return time ? readDuration(rest, units, value) : readPart(rest, units, value, factor);
}

}  // namespace

bool Units::next() {
  constexpr uint32_t kDigits = 16;
  const char* equals = strchr(rest_, '=');
  if (equals == nullptr || strlen(equals + 1) < kDigits) {
    return false;
  }
  name_ = {rest_, equals};
  factor_ = doubleOf(hexadecimal(equals + 1, kDigits));
  rest_ = equals + 1 + kDigits;
  rest_ += *rest_ == ' ' ? 1 : 0;
  return true;
}

bool isTruth(const char* units) {
  return strcmp(units, "bool") == 0;
}

bool isOnEarth(const char* units) {
  return units[0] == 'N' || units[0] == 'E';  // no other list begins with these
}

Reading readQuantity(const Piece& text, const char* units, double& value) {
  Piece rest = text.trimmed();
  if (isTruth(units)) {
    value = rest.is("true") ? 1.0 : 0.0;
    return rest.is("true") || rest.is("false") ? Reading::Good : Reading::NotANumber;
  }
  return isOnEarth(units) ? readHalf(rest, units, value) : readNumber(rest, units, value);
}

}  // namespace glider::runtime
