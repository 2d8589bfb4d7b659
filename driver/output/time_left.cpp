// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/output/time_left.h"

#include <fmt/format.h>

#include <cmath>

namespace glider::driver {

std::string TimeLeft::of(uint64_t done, uint64_t all, Clock::time_point now) {
  constexpr double kFirst_s = 3;  // sooner, one part more or less changes the estimate too much
  constexpr double kMinute_s = 60;
  constexpr double kHour_s = 3600;
  if (!beginning_) {
    beginning_ = {done, now};
    return "";
  }
  const double took_s = std::chrono::duration<double>(now - beginning_->when).count();
  const auto parts = static_cast<double>(done - beginning_->done);
  if (took_s < kFirst_s || parts < 1 || done >= all) {
    return "";
  }
  const double left_s = took_s / parts * static_cast<double>(all - done);
  const std::string text = left_s < kMinute_s ? fmt::format("{:.0f} s", std::ceil(left_s))
                           : left_s < kHour_s
                               ? fmt::format("{:.0f} min", std::ceil(left_s / kMinute_s))
                               : fmt::format("{:.1f} h", left_s / kHour_s);
  return fmt::format("about {} left", text);
}

}  // namespace glider::driver
