// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/result.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// extctl.ini: which sensors cross the vehicle's port for a backseat driver.
namespace glider::slocum {

/// A line `name unit` of a section; the unit, a description only, may be missing.
struct ExtctlSensor {
  std::string name;
  std::string unit;
};

/// A sensor's index on the port counts from 0 through `parameters`, `written` and `reported`.
struct ExtctlFile {
  static constexpr uint32_t kUsualBaud = 9600;
  static constexpr uint32_t kUsualPacket = 600;

  std::vector<ExtctlSensor> parameters;  ///< section mp: u_mission_param_…, the SBC writes them
  std::vector<ExtctlSensor> written;     ///< os: other sensors that the SBC writes
  std::vector<ExtctlSensor> reported;    ///< is: those that the vehicle reports
  uint32_t baud = kUsualBaud;
  uint32_t packet_bytes = kUsualPacket;  ///< of a chunk of a file

  /// All of them, by index.
  [[nodiscard]] std::vector<ExtctlSensor> sensors() const;
};

/// Reads the text of a file named `name`. Names are kept in lower case. Fails with GL5130: a line
/// outside every section, a number that is none, a sensor given twice.
support::Result<ExtctlFile> readExtctlFile(std::string_view name, std::string_view text);

/// The text of a file, with `comment` in lines before its sections.
std::string printExtctlFile(const ExtctlFile& file, std::string_view comment);

}  // namespace glider::slocum
