// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/window_shape.h"

#include <algorithm>
#include <cmath>

namespace glider::ir {
namespace {

constexpr double kCycle = 4;  ///< s between the vehicle's frames
constexpr double kMostBins = 256;
constexpr double kBinsOfStretch = 32;

}  // namespace

WindowShape windowShape(const Temporal& window) {
  const bool stretch = window.along.valid();
  const double across =
      stretch ? kBinsOfStretch : std::clamp(std::ceil(window.length / kCycle), 1.0, kMostBins);
  // The two ends may cut a bin, so one more than fits, and one for rounding.
  const double bins = (stretch ? 2 * across : across) + 2;
  return {window.kind, stretch, window.length, window.length / across, static_cast<uint32_t>(bins)};
}

}  // namespace glider::ir
