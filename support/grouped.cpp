// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/grouped.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>

namespace glider::support {

std::string grouped(uint64_t number) {
  constexpr size_t kGroup = 3;
  std::string text = std::to_string(number);
  for (size_t at = text.size(); at > kGroup;) {
    at -= kGroup;
    text.insert(at, 1, ',');
  }
  return text;
}

namespace {

/// `amount` in steps of which three digits have room, to the step below or above.
std::string inSteps(double amount, double (*whole)(double)) {
  constexpr double kWhole = 100;
  if (!(amount < kWhole)) {
    return grouped(static_cast<uint64_t>(whole(amount)));
  }
  if (!(amount > 0)) {
    return "0";
  }
  constexpr int kDigits = 3;
  const int before = static_cast<int>(std::floor(std::log10(amount))) + 1;
  const double step = std::pow(10.0, kDigits - before);
  // A whole number of steps, except for the last digits of a double, stays.
  constexpr double kSame = 1e-9;
  const double near = std::round(amount * step);
  const double steps = std::fabs(amount * step - near) < kSame * near ? near : whole(amount * step);
  return fmt::format("{:g}", steps / step);
}

}  // namespace

std::string atMost(double amount) {
  return inSteps(amount, [](double x) { return std::ceil(x); });
}

std::string atLeast(double amount) {
  return inSteps(amount, [](double x) { return std::floor(x); });
}

}  // namespace glider::support
