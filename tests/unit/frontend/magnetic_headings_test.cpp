// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// `heading > 180 deg magnetic` compares what the vehicle's compass shows.

#include "ir/eval/interpreter.h"
#include "platforms/load/platform.h"
#include "tests/unit/frontend/compile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glider::frontend {
namespace {

using testing_support::FrontendRun;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kTurn = 2 * std::numbers::pi;

/// As runtime/core/compass converts a heading of the vehicle.
double trueHeading(double magnetic, double variation) {
  double sum = magnetic - variation;
  sum += sum < 0 ? kTurn : sum >= kTurn ? -kTurn : 0;
  return sum < kTurn ? sum : 0;
}

class MagneticHeadings : public testing::Test {
 protected:
  /// Whether the condition is true where the compass shows `shown` degrees.
  static bool isTrue(const std::string& condition, double shown, double variation,
                     bool reported = true) {
    FrontendRun run(
        fmt::format("mission m\n{}state s\nbegin\n flightprofile surfaced\n"
                    " sensors missiontime, heading\n events\n case {} exit\n"
                    " case missiontime > 1 h exit\nend\n",
                    reported ? "" : fmt::format("declination {} deg\n", -variation), condition));
    const auto mission = run.compile();
    EXPECT_TRUE(mission.has_value()) << run.said();
    if (!mission) {
      return false;
    }
    const auto named = [&](std::string_view name) {
      const auto& sensors = mission->sensors;
      const auto found = std::ranges::find(sensors, name, &ir::Sensor::vehicle_name);
      return ir::SensorId{static_cast<uint32_t>(found - sensors.begin())};
    };
    const double heading = trueHeading(shown * kDegree, variation * kDegree);
    std::vector<ir::SensorUpdate> frame{{named("m_heading"), heading}};
    if (reported) {
      frame.push_back({named(platforms::kVariationSensor), variation * kDegree});
    }
    ir::Interpreter flight(*mission, 1);
    flight.start();
    return flight.tick(4, frame).finished;
  }
};

TEST_F(MagneticHeadings, AreComparedAsTheCompassShowsThem) {
  for (const double variation : {-170.0, -12.0, 0.0, 0.7, 12.0, 180.0}) {
    for (const double shown : {0.0, 2.0, 100.0, 179.0, 181.0, 350.0, 359.99}) {
      for (const bool reported : {true, false}) {
        SCOPED_TRACE(fmt::format("{} deg shown, variation {}, {}", shown, variation, reported));
        const auto is = [&](const std::string& c) { return isTrue(c, shown, variation, reported); };
        EXPECT_EQ(is("heading > 180 deg magnetic"), shown > 180);
        EXPECT_EQ(is("5 deg magnetic >= heading"), shown < 5);
        EXPECT_EQ(is("heading >= 5 deg magnetic && heading < 120 deg magnetic"),
                  shown > 5 && shown < 120);
        EXPECT_EQ(is("heading > magnetic(10 deg * 35.5)"), shown > 355);
      }
    }
  }
}

TEST_F(MagneticHeadings, ANorthOfTheCompassIsTheLeastWhateverIsRounded) {
  for (double variation = -180; variation <= 180; variation += 7.3) {
    EXPECT_FALSE(isTrue("heading > 5 deg magnetic", 0, variation)) << variation;
    EXPECT_TRUE(isTrue("heading >= 0 deg magnetic", 0, variation)) << variation;
  }
}

TEST_F(MagneticHeadings, BothSidesMayBeMagnetic) {
  EXPECT_TRUE(isTrue("350 deg magnetic > 10 deg magnetic", 0, 12));
  EXPECT_FALSE(isTrue("magnetic(10 deg) > 350 deg magnetic", 0, -12));
}

/// Only beside the comparison; a sum, a maximum and a variable are true headings.
TEST_F(MagneticHeadings, ElsewhereAreTrueHeadings) {
  EXPECT_FALSE(isTrue("heading > 5 deg magnetic + 0 deg", 100, 12));
  EXPECT_TRUE(isTrue("heading > 20 deg magnetic + 0 deg", 100, 12));
}

}  // namespace
}  // namespace glider::frontend
