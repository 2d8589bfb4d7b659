// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/falsification/random_place.h"

#include "ir/core/inside.h"

#include <gtest/gtest.h>

#include <vector>

namespace glider::ir::prove {
namespace {

Geofence areaOf(std::vector<Position> corners) {
  Geofence area;
  area.corners = std::move(corners);
  return area;
}

/// None of these fills much of the smallest and largest latitudes and longitudes of its corners.
TEST(PlaceInside, IsInside) {
  const std::vector<Geofence> areas = {
      areaOf({{39.0, -74.0}, {39.2, -73.8}, {39.2001, -73.8}}),              // thin
      areaOf({{-10, 179.9}, {-10, -179.9}, {-9.9, -179.9}, {-9.9, 179.9}}),  // across 180° E
      areaOf({{39, -74}, {40, -74}, {40, -73.99}, {39.01, -73.99}, {39.01, -73}, {39, -73}}),  // L
  };
  for (size_t i = 0; i < areas.size(); ++i) {
    for (uint64_t seed = 0; seed < 200; ++seed) {
      Rng dice(seed);
      const auto place = placeInside(areas[i], dice);
      ASSERT_TRUE(place.has_value()) << "area " << i << ", seed " << seed;
      EXPECT_TRUE(isInside(areas[i], *place)) << "area " << i << ", seed " << seed;
    }
  }
}

TEST(PlaceInside, IsNowhereOnALine) {
  Rng dice(1);
  EXPECT_FALSE(placeInside(areaOf({{39, -74}, {39, -73}, {39, -72}}), dice).has_value());
}

}  // namespace
}  // namespace glider::ir::prove
