// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace glider::driver {

/// Estimates when long work will be over, from how fast it went since it began.
class TimeLeft {
 public:
  using Clock = std::chrono::steady_clock;

  /// "about 8 min left" when `done` of `all` parts are done; empty in the first seconds, and at the
  /// end. The first call is the beginning: what is done then took no time.
  std::string of(uint64_t done, uint64_t all, Clock::time_point now = Clock::now());

 private:
  struct Beginning {
    uint64_t done;
    Clock::time_point when;
  };
  std::optional<Beginning> beginning_;
};

}  // namespace glider::driver
