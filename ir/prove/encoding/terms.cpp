// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/encoding/terms.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace glider::ir::prove {
namespace {

/// 2^count as decimal digits.
std::string powerOfTwo(int count) {
  std::string digits = "1";  // least significant first
  for (int i = 0; i < count; ++i) {
    int carry = 0;
    for (char& digit : digits) {
      const int doubled = 2 * (digit - '0') + carry;
      digit = static_cast<char>('0' + doubled % 10);
      carry = doubled / 10;
    }
    if (carry != 0) {
      digits += '1';
    }
  }
  return {digits.rbegin(), digits.rend()};
}

}  // namespace

z3::expr realOf(z3::context& context, double value) {
  if (value == std::floor(value) && std::fabs(value) < 1e15) {
    return context.real_val(static_cast<int64_t>(value));
  }
  constexpr int kDigits = 53;
  int exponent = 0;
  const auto whole =
      static_cast<int64_t>(std::ldexp(std::frexp(value, &exponent), kDigits));  // exact
  exponent -= kDigits;
  const z3::expr scaled = context.real_val(whole);
  const z3::expr power = context.real_val(powerOfTwo(std::abs(exponent)).c_str());
  return (exponent < 0 ? scaled / power : scaled * power).simplify();
}

double doubleOf(const z3::model& model, const z3::expr& value) {
  constexpr int kDigits = 20;
  const std::string text = model.eval(value, true).get_decimal_string(kDigits);
  return std::strtod(text.c_str(), nullptr);  // a trailing `?` marks more digits
}

bool holds(const z3::model& model, const z3::expr& truth) {
  return model.eval(truth, true).is_true();
}

}  // namespace glider::ir::prove
