// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <string>

namespace glider::ir::prove {

/// "2 h 1 min 12 s", from three days on "5 days 1 h 0 min 20 s"; rounded up; an excess of
/// less than a millisecond is ignored.
inline std::string durationOf(double seconds) {
  constexpr int64_t kDay_s = 86400, kHour_s = 3600;
  const auto whole = static_cast<int64_t>(std::ceil(seconds - 1e-3));
  const int64_t days = whole >= 3 * kDay_s ? whole / kDay_s : 0;
  std::string text = days > 0 ? fmt::format("{} days ", days) : "";
  text += whole >= kHour_s ? fmt::format("{} h ", (whole - days * kDay_s) / kHour_s) : "";
  text += whole >= 60 ? fmt::format("{} min ", whole / 60 % 60) : "";
  return text + fmt::format("{} s", whole % 60);
}

}  // namespace glider::ir::prove
