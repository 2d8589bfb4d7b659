// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::simulator {

/// m or m/s towards east and north.
struct Planar {
  double east = 0, north = 0;

  bool operator==(const Planar&) const = default;
};

}  // namespace glider::simulator
