// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/units/duration_text.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <utility>

namespace glider::support {

std::string durationText(double seconds) {
  constexpr double kMinute = 60, kLongest = 1e10;
  constexpr int64_t kSixty = 60, kHour = 3600, kDay = 86400;
  const double size = std::fabs(seconds);
  if (!(size >= kMinute - 0.5 && size < kLongest)) {
    return fmt::format("{:.5g} s", seconds + 0.0);
  }
  const int64_t whole = std::llround(size);
  std::string text = seconds < 0 ? "-" : "";
  const auto add = [&](int64_t count, const char* unit) {
    if (count > 0) {
      text += fmt::format("{}{} {}", text.size() > 1 ? " " : "", count, unit);
    }
  };
  add(whole / kDay, whole / kDay == 1 ? "day" : "days");
  add(whole % kDay / kHour, "h");
  add(whole % kHour / kSixty, "min");
  add(whole % kSixty, "s");
  return text;
}

std::string durationArgument(double seconds) {
  constexpr std::pair<int64_t, const char*> kUnits[] = {{86400, "days"}, {3600, "h"}, {60, "min"}};
  const int64_t whole = std::llround(seconds);
  for (const auto& [length, unit] : kUnits) {
    if (whole != 0 && whole % length == 0) {
      return fmt::format("{}{}", whole / length, whole == length && length == 86400 ? "day" : unit);
    }
  }
  return fmt::format("{}s", whole);
}

}  // namespace glider::support
