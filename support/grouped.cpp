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

std::string groupedAmount(double amount) {
  constexpr double kWhole = 100;
  return amount < kWhole ? fmt::format("{:.3g}", amount)
                         : grouped(static_cast<uint64_t>(std::ceil(amount)));
}

}  // namespace glider::support
