// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <functional>
#include <string>
#include <vector>

namespace glider::tests {

/// A value that a mission leaves open, and the values that it can have: numbers of its unit.
struct OpenValue {
  std::string name;
  std::string type;
  std::string unit;
  double lowest = 0, highest = 0, step = 1;
  std::string where = "";  ///< of its line; empty: none
};

/// What a mission leaves open, and independently of its text what is allowed and preferred.
struct Problem {
  std::string name;
  std::vector<OpenValue> open;
  std::string prefer;  ///< of the mission's line; empty: it has none
  std::string rest;    ///< of the mission
  /// Whether the values, of `open` in its order and units, go together.
  std::function<bool(const std::vector<double>&)> allowed;
  /// How good they are, the most important first; the lower, the better. Then comes the energy.
  std::function<std::vector<double>(const std::vector<double>&)> scores;
};

/// Problems of gliders, and one of UNDERSEA's kind (three sensors to switch on, and a speed).
std::vector<Problem> planProblems();

/// A value of `open` as a mission has it: "65 m".
std::string valueText(const OpenValue& open, double value);

/// The mission that leaves all of them open.
std::string openText(const Problem& problem);

}  // namespace glider::tests
