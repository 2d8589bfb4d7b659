// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace glider::codegen {

/// How a part of a built mission compares with what the mission means.
enum class Verdict : uint8_t {
  Same,     ///< proved for all readings, variables and times
  Differs,  ///< there are some for which it does something else
  Undecided
};

struct Validated {
  std::string what;  ///< "the cases of `dive`"
  Verdict verdict = Verdict::Same;
  std::string words;  ///< what differs and when; why it is not decided
};

/// The parts of a mission's code and tables, each compared with the mission.
using Validation = std::vector<Validated>;

}  // namespace glider::codegen
