// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::simulator {

/// Where a vehicle truly is: m east and north of the world's origin, and below the surface.
struct TruePlace {
  double east_m = 0;
  double north_m = 0;
  double depth_m = 0;
};

}  // namespace glider::simulator
