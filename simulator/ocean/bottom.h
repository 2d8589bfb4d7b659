// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/ocean/settings.h"

#include <utility>

namespace glider::simulator {

/// The bottom: circular waves around the start, on a plane that may slope, with seamounts.
class Bottom {
 public:
  explicit Bottom(BottomSettings settings) : settings_(std::move(settings)) {}

  /// Depth of the water (m) at x, y (m east and north of the start); 0 on land.
  [[nodiscard]] double depth(double x, double y) const;

 private:
  BottomSettings settings_;
};

}  // namespace glider::simulator
