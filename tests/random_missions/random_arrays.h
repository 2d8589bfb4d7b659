// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace glider::random_missions {

/// The values of the variables of a program; NaN: unknown.
struct Memory {
  std::map<std::string, double> numbers;
  std::map<std::string, std::vector<double>> arrays;
};

/// Statements of the mission language with arrays and loops, and a model that runs them as they
/// read, with real loops and real arrays. Indices may be anything, and many values are unknown.
struct RandomArrays {
  std::string declarations;
  std::string statements;
  Memory memory;  ///< as it begins
  std::function<void(Memory&)> run;
};
RandomArrays randomArrays(uint64_t seed);

}  // namespace glider::random_missions
