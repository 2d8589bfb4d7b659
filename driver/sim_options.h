// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace glider::driver {

/// What `glidercc sim` was asked for.
struct SimOptions {
  std::string mission;               ///< empty with --sbc or --no-sbc
  std::string scenario = "default";  ///< a file, or the name of one that comes with glidercc
  std::string board;                 ///< empty: in this process
  std::string program;               ///< --sbc: an SBC program to fly instead of a mission
  bool without_sbc = false;
  std::optional<uint64_t> seed;
  std::optional<double> kill_sbc_at_s;
  std::string output;  ///< folder; empty: named after the mission
};

}  // namespace glider::driver
