// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "driver/mission_log/render.h"

#include <string>

namespace glider::runtime::testing {

/// A mission log as `glidercc log --csv` writes it.
inline std::string csvOf(const std::string& log, driver::LogDamage* damage = nullptr) {
  std::string csv = driver::kLogCsvHead;
  const auto found =
      driver::readLog(log, [&](const driver::LogEntry& entry) { csv += driver::csvLines(entry); });
  if (damage != nullptr) {
    *damage = found;
  }
  return csv;
}

}  // namespace glider::runtime::testing
