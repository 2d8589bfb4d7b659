// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/boards/trial.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace {

std::optional<double> mean(std::span<const double> depths) {
  if (depths.empty()) {
    return std::nullopt;
  }
  double sum = 0;
  for (double depth : depths) {
    sum += depth;
  }
  return sum / static_cast<double>(depths.size());
}

}  // namespace

double trialMeanDepth(const double* depths, unsigned count) {
  return mean({depths, std::size_t{count}}).value_or(0.0);
}
