// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/log/format.h"

#include "runtime/numbers/numbers.h"

namespace glider::runtime {
namespace {

constexpr int32_t kDigits = 12;
constexpr int32_t kLeastPlain = -5;
constexpr int32_t kMostPlain = 15;

struct Power {
  double value;
  int32_t exponent;
};
constexpr Power kPowers[] = {{1e256, 256}, {1e128, 128}, {1e64, 64}, {1e32, 32}, {1e16, 16},
                             {1e8, 8},     {1e4, 4},     {1e2, 2},   {1e1, 1}};

/// Scales a positive finite value into [1, 10); returns its decimal exponent.
int32_t scale(double& value) {
  int32_t exponent = 0;
  for (const Power& power : kPowers) {
    if (value >= power.value) {
      value /= power.value;
      exponent += power.exponent;
    }
  }
  if (value >= 1.0) {
    return exponent;
  }
  for (const Power& power : kPowers) {
    if (value * power.value < 10.0) {
      value *= power.value;
      exponent -= power.exponent;
    }
  }
  return exponent;
}

void sixDigits(uint32_t value, char* out) {
  for (int i = 5; i >= 0; --i) {
    out[i] = static_cast<char>('0' + value % 10U);
    value /= 10U;
  }
}

/// The digits of a value in [1, 10), rounded. Returns 1 if that made it 10, else 0.
int32_t digitsOf(double value, char* digits) {
  double whole = value * 1e11 + 0.5;
  const int32_t carry = whole >= 1e12 ? 1 : 0;
  if (carry != 0) {
    whole = 1e11;
  }
  // Two halves: 64-bit division is a library call on the small boards.
  const auto high = static_cast<uint32_t>(whole / 1e6);
  sixDigits(high, digits);
  sixDigits(static_cast<uint32_t>(whole - 1e6 * static_cast<double>(high)), digits + 6);
  return carry;
}

void putPlain(Text& text, const char* digits, int32_t count, int32_t exponent) {
  if (exponent < 0) {
    text.put("0.");
    for (int32_t i = exponent + 1; i < 0; ++i) {
      text.put('0');
    }
  }
  for (int32_t i = 0; i < count || i <= exponent; ++i) {
    text.put(i < count ? digits[i] : '0');
    if (i == exponent && i + 1 < count) {
      text.put('.');
    }
  }
}

void putWithExponent(Text& text, const char* digits, int32_t count, int32_t exponent) {
  text.put(digits[0]);
  if (count > 1) {
    text.put('.').put(digits + 1, static_cast<uint32_t>(count - 1));
  }
  text.put('e').put(exponent < 0 ? '-' : '+');
  text.putCount(static_cast<uint32_t>(exponent < 0 ? -exponent : exponent));
}

}  // namespace

uint32_t formatNumber(double value, char* out) {
  Text text(out, kNumberBytes);
  if (value != value) {
    return 0;
  }
  if (value < 0.0) {
    text.put('-');
  }
  double rest = magnitude(value);
  if (!isFinite(rest)) {
    text.put("inf");
  } else if (rest == 0.0) {
    text.put('0');
  } else {
    char digits[kDigits + 1] = {};
    int32_t exponent = scale(rest);
    exponent += digitsOf(rest, digits);
    int32_t count = kDigits;
    while (count > 1 && digits[count - 1] == '0') {
      --count;
    }
    const bool plain = exponent >= kLeastPlain && exponent < kMostPlain;
    plain ? putPlain(text, digits, count, exponent)
          : putWithExponent(text, digits, count, exponent);
  }
  return text.size();
}

uint32_t formatCount(uint32_t value, char* out) {
  char backwards[10];
  uint32_t count = 0;
  do {
    backwards[count++] = static_cast<char>('0' + value % 10U);
    value /= 10U;
  } while (value != 0);
  for (uint32_t i = 0; i < count; ++i) {
    out[i] = backwards[count - 1 - i];
  }
  return count;
}

__attribute__((noinline)) Text& Text::put(char c) {
  if (size_ < capacity_) {
    bytes_[size_++] = c;
  } else {
    full_ = true;
  }
  return *this;
}

Text& Text::put(const char* text, uint32_t most) {
  for (uint32_t i = 0; i < most && text[i] != '\0'; ++i) {
    put(text[i]);
  }
  return *this;
}

Text& Text::put(double value) {
  char number[kNumberBytes];
  return put(number, formatNumber(value, number));
}

Text& Text::putCount(uint32_t value) {
  char number[10];
  return put(number, formatCount(value, number));
}

}  // namespace glider::runtime
