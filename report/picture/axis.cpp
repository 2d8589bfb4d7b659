// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/picture/axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::report::picture {

double niceStep(double span, int most) {
  const double least = span / most;
  const double power = std::pow(10, std::floor(std::log10(least)));
  constexpr double kRounding = 1 + 1e-9;
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power * kRounding >= least) {
      return factor * power;
    }
  }
  return 10 * power;
}

std::vector<double> ticks(double from, double to, double step) {
  std::vector<double> out;
  constexpr double kSlack = 1e-9;
  const double first = std::ceil(from / step - kSlack), last = std::floor(to / step + kSlack);
  for (double i = first; i <= last; ++i) {
    out.push_back(i * step + 0.0);
  }
  return out;
}

std::string tickText(double value, double step) {
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 6);
  const std::string text = fmt::format("{:.{}f}", std::fabs(value), decimals);
  return value < 0 ? "\u2212" + text : text;
}

}  // namespace glider::report::picture
