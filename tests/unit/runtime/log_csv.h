// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "logs/render.h"

#include <string>

namespace glider::runtime::testing {

/// A mission log as `glidercc log --csv` writes it.
inline std::string csvOf(const std::string& log, logs::LogDamage* damage = nullptr) {
  std::string csv = logs::kLogCsvHead;
  const auto found =
      logs::readLog(log, [&](const logs::LogEntry& entry) { csv += logs::csvLines(entry); });
  if (damage != nullptr) {
    *damage = found;
  }
  return csv;
}

}  // namespace glider::runtime::testing
