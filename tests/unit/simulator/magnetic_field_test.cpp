// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The magnetic field against the test values that come with the model.

#include "simulator/magnetism/magnetic_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <numbers>

namespace glider::simulator {
namespace {

struct TestValue {
  double year, height_km, latitude_deg, longitude_deg, horizontal_nT, inclination_deg,
      declination_deg;
};
constexpr TestValue kValues[] = {
#define VALUE(...) {__VA_ARGS__},
#include "tests/unit/simulator/wmm2025_values.def"
#undef VALUE
};
constexpr double kDegPerRad = 180 / std::numbers::pi;

TEST(MagneticField, AgreesWithThePublishedTestValues) {
  EXPECT_EQ(std::size(kValues), 100U);
  for (const TestValue& v : kValues) {
    SCOPED_TRACE(testing::Message() << v.year << ", " << v.height_km << " km, " << v.latitude_deg
                                    << ", " << v.longitude_deg);
    const MagneticField field = magneticField(v.latitude_deg, v.longitude_deg, v.height_km, v.year);
    // Given to a hundredth of a degree and, here, a tenth of a nT.
    EXPECT_NEAR(field.horizontal_nT, v.horizontal_nT, 0.051);
    EXPECT_NEAR(field.inclination_rad * kDegPerRad, v.inclination_deg, 0.0051);
    EXPECT_NEAR(field.declination_rad * kDegPerRad, v.declination_deg, 0.0051);
  }
}

TEST(MagneticField, PointsWestOffNewJerseyAndEastOffBritishColumbia) {
  EXPECT_NEAR(magneticField(39.175, -73.835, 0, 2025).declination_rad * kDegPerRad, -12.3, 0.5);
  // Real vehicles' m_gps_mag_var there: +16.3 degrees in 2023, -18.2 (an older model's).
  EXPECT_NEAR(magneticField(38.0, -62.4, 0, 2025).declination_rad * kDegPerRad, -15.0, 1.5);
  EXPECT_GT(magneticField(51.65, -128.1, 0, 2025).declination_rad * kDegPerRad, 14.0);
}

TEST(MagneticField, IsFiniteAtThePoles) {
  for (const double latitude : {-90.0, 90.0}) {
    const MagneticField field = magneticField(latitude, 10, 0, 2027);
    EXPECT_TRUE(std::isfinite(field.declination_rad));
    EXPECT_NEAR(std::fabs(field.inclination_rad) * kDegPerRad, latitude > 0 ? 88 : 72, 2);
  }
}

}  // namespace
}  // namespace glider::simulator
