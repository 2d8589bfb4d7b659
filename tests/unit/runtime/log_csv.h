// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "logs/render.h"

#include <sstream>
#include <string>
#include <vector>

namespace glider::runtime::testing {

/// A mission log as `glidercc log --csv` writes it.
inline std::string csvOf(const std::string& log, logs::LogDamage* damage = nullptr) {
  std::string csv = logs::csvHead();
  const auto found =
      logs::readLog(log, [&](const logs::LogEntry& entry) { csv += logs::csvLines(entry); });
  if (damage != nullptr) {
    *damage = found;
  }
  return csv;
}

/// The lines about the event with this name.
inline std::vector<std::string> eventsIn(const std::string& csv, const std::string& name) {
  std::vector<std::string> found;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    if (line.find(",event," + name + ",") != std::string::npos) {
      found.push_back(line);
    }
  }
  return found;
}

}  // namespace glider::runtime::testing
