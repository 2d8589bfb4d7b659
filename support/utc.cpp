// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/utc.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

namespace glider::support {

std::string utcText(double time_s) {
  // From 1900 to 2200: anything else is a clock that was never set, or damage.
  if (!(time_s > -2208988800.0 && time_s < 7258118400.0)) {
    return "unknown";
  }
  const std::chrono::sys_seconds seconds{
      std::chrono::seconds(static_cast<int64_t>(std::floor(time_s)))};
  const auto days = std::chrono::floor<std::chrono::days>(seconds);
  const std::chrono::year_month_day day(days);
  const int64_t rest = (seconds - days).count();
  return fmt::format("{:04}-{:02}-{:02} {:02}:{:02}:{:02}", static_cast<int>(day.year()),
                     static_cast<unsigned>(day.month()), static_cast<unsigned>(day.day()),
                     rest / 3600, rest / 60 % 60, rest % 60);
}

std::string instantText(double time_s) {
  std::string text = utcText(time_s);
  const size_t gap = text.find(' ');
  if (gap != std::string::npos) {
    text[gap] = 'T';
    text += 'Z';
  }
  return text;
}

}  // namespace glider::support
