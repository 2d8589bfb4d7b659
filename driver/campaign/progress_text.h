// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "driver/output/time_left.h"
#include "support/counted.h"

#include <fmt/format.h>

#include <cstdint>
#include <string>

namespace glider::driver {

/// "123 of 1000 flights, about 8 min left".
inline std::string progressText(uint64_t over, uint64_t all, TimeLeft& left) {
  const std::string estimate = left.of(over, all);
  return fmt::format("{} of {}{}", over, support::counted(all, "flight"),
                     estimate.empty() ? "" : ", " + estimate);
}

}  // namespace glider::driver
