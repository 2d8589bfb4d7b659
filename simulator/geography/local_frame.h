// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <GeographicLib/LocalCartesian.hpp>

namespace glider::simulator {

/// North and east positive.
struct GeoPosition {
  double latitude_deg = 0, longitude_deg = 0;
  bool operator==(const GeoPosition&) const = default;
};

/// Converts metres east and north of a place on the ellipsoid to degrees and back.
class LocalFrame {
 public:
  LocalFrame(double latitude_deg, double longitude_deg) : frame_(latitude_deg, longitude_deg) {}
  [[nodiscard]] GeoPosition position(double x, double y) const;
  /// x and y of a position.
  void locate(GeoPosition position, double& x, double& y) const;

 private:
  GeographicLib::LocalCartesian frame_;
};

}  // namespace glider::simulator
