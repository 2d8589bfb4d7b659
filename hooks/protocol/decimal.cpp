// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/decimal.h"

#include "hooks/protocol/numbers.h"

namespace glider::hooks {
namespace {

constexpr double kMost = 1e12;
constexpr int kDecimals = 6;
constexpr double kMillion = 1e6;

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

/// The text that is still to be read.
struct Rest {
  const char* next;
  const char* end;

  [[nodiscard]] bool empty() const { return next == end; }
  [[nodiscard]] char first() const { return empty() ? '\0' : *next; }
  bool take(char lower) {
    const bool is = !empty() && (*next | 0x20) == lower;
    next += is ? 1 : 0;
    return is;
  }
  bool takeSign() {
    const bool negative = first() == '-';
    next += negative || first() == '+' ? 1 : 0;
    return negative;
  }
  bool takeWord(const char* lower) {
    for (; *lower != '\0'; ++lower) {
      if (!take(*lower)) {
        return false;
      }
    }
    return empty();
  }
};

/// The digits of a number: `digits` times ten to the power of `exponent`.
struct Digits {
  uint64_t digits = 0;
  int exponent = 0;
  bool any = false;

  void add(char digit, bool after_point) {
    constexpr uint64_t kRoom = 100'000'000'000'000'000;  // one more digit fits into 64 bits
    any = true;
    if (digits < kRoom) {
      digits = digits * 10 + static_cast<uint64_t>(digit - '0');
      exponent -= after_point ? 1 : 0;
    } else {
      exponent += after_point ? 0 : 1;
    }
  }
};

Digits takeDigits(Rest& rest) {
  Digits number;
  bool after_point = false;
  for (; !rest.empty(); ++rest.next) {
    if (isDigit(*rest.next)) {
      number.add(*rest.next, after_point);
    } else if (*rest.next == '.' && !after_point) {
      after_point = true;
    } else {
      break;
    }
  }
  return number;
}

/// False without a digit. Exponents that no double has end at the greatest.
bool takeExponent(Rest& rest, int* exponent) {
  constexpr int kGreatest = 400;
  const bool negative = rest.takeSign();
  int size = 0;
  const bool any = isDigit(rest.first());
  for (; isDigit(rest.first()); ++rest.next) {
    size = size < kGreatest ? size * 10 + (*rest.next - '0') : kGreatest;
  }
  *exponent += negative ? -size : size;
  return any;
}

/// One rounding while the digits and the power of ten are exact, a few in all.
double scaled(double digits, int exponent) {
  constexpr double kTens[] = {1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                              1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  constexpr int kLast = 22;
  while (exponent > 0 && digits != 0 && hookIsFinite(digits)) {
    const int step = exponent < kLast ? exponent : kLast;
    digits *= kTens[step - 1];
    exponent -= step;
  }
  while (exponent < 0 && digits != 0) {
    const int step = -exponent < kLast ? -exponent : kLast;
    digits /= kTens[step - 1];
    exponent += step;
  }
  return digits;
}

/// In millionths, to the nearest. The whole part is taken off first: of a large number, millions
/// would have no room for halves.
int64_t millionths(double value) {
  const double within = hookBetween(value, -kMost, kMost);
  const auto whole = static_cast<int64_t>(within);
  const double part = within - static_cast<double>(whole);
  return whole * 1'000'000 + static_cast<int64_t>(part * kMillion + (within < 0 ? -0.5 : 0.5));
}

}  // namespace

bool readDecimal(const char* text, uint32_t count, double* value) {
  Rest rest{text, text + count};
  const bool negative = rest.takeSign();
  if (Rest word = rest; word.takeWord("nan") || (word = rest).takeWord("inf")) {
    *value = __builtin_nan("");
    return true;
  }
  Digits number = takeDigits(rest);
  if (!number.any || (rest.take('e') && !takeExponent(rest, &number.exponent)) || !rest.empty()) {
    return false;
  }
  const double size = scaled(static_cast<double>(number.digits), number.exponent);
  *value = !hookIsFinite(size) ? __builtin_nan("") : negative ? -size : size;
  return true;
}

uint32_t writeDecimal(double value, char* text) {
  if (value != value) {
    text[0] = text[2] = 'n';
    text[1] = 'a';
    return 3;
  }
  uint32_t count = 0;
  const int64_t whole = millionths(value);
  uint64_t rest = static_cast<uint64_t>(whole < 0 ? -whole : whole);
  char digits[kMostDecimal];
  uint32_t places = 0;
  while (rest != 0 || places <= kDecimals) {
    digits[places++] = static_cast<char>('0' + rest % 10);
    rest /= 10;
  }
  if (whole < 0) {
    text[count++] = '-';
  }
  while (places != 0) {
    text[count++] = digits[--places];
    if (places == kDecimals) {
      text[count++] = '.';
    }
  }
  return count;
}

double asSixDecimals(double value) {
  char text[kMostDecimal];
  double read = 0;
  const uint32_t count = writeDecimal(value, text);
  return readDecimal(text, count, &read) ? read : __builtin_nan("");
}

}  // namespace glider::hooks
