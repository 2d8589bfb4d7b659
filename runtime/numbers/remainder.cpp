// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/abi/glider_abi.h"
#include "runtime/numbers/numbers.h"
#include "runtime/numbers/pair.h"

namespace glider::runtime {
namespace {

constexpr double kMostQuotient = 2147483648.0;
/// Products of numbers in this range keep all their digits (pair.h).
constexpr double kSmallest = 0x1p-400;
constexpr double kGreatest = 0x1p400;

bool isUsual(double x) {
  const double size = magnitude(x);
  return x == 0.0 || (size >= kSmallest && size <= kGreatest);  // false for NaN
}

}  // namespace
}  // namespace glider::runtime

/// x less the whole multiple of y below it. The quotient may round up to the next whole number, or
/// down past one: then the difference is just below 0 or at y, and one y more or less is right.
extern "C" double gliderRemainder(double x, double y) {
  using namespace glider::runtime;
  if (!isUsual(x) || !isUsual(y) || !(y > 0.0) || !(magnitude(x / y) < kMostQuotient)) {
    return unknown();
  }
  const double whole = static_cast<double>(static_cast<int32_t>(x / y));
  const Pair taken = productOf(whole, y);
  double rest = (x - taken.high) - taken.low;
  rest = rest < 0.0 ? rest + y : rest;
  rest = rest < 0.0 ? rest + y : rest;
  rest = rest >= y ? rest - y : rest;
  return gliderSettle(rest < 0.0 ? 0.0 : rest);
}
