// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Which missions have a compass, and what is said where nothing will tell the declination.

#include "platforms/load/load_platform.h"
#include "support/diagnostics/ids/meaning.h"
#include "tests/unit/frontend/compile.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::frontend {
namespace {

using testing_support::FrontendRun;
using testing_support::readSource;

/// A mission with a route, a guard and lines of its own.
std::string missionOn(const std::string& line, const std::string& route,
                      const std::string& guard = "missiontime > 1 h") {
  return fmt::format(
      "mission m\n{}\nstate s\nbegin\n flightprofile surfaced\n flightroute {}\n"
      " sensors missiontime, lat, lon\n events\n case {} exit\nend\n",
      line, route, guard);
}

/// Of the Slocum, or of one whose GPS tells no variation.
class Declination : public testing::TestWithParam<bool> {
 protected:
  std::optional<ir::Mission> compile(FrontendRun& run) const {
    auto platform = platforms::loadPlatform(GLIDER_SOURCE_DIR "/platforms/slocum.toml");
    EXPECT_TRUE(platform.has_value());
    if (!GetParam()) {
      EXPECT_EQ(std::erase_if(platform->sensors,
                              [](const platforms::PlatformSensor& sensor) {
                                return sensor.name == platforms::kVariationSensor;
                              }),
                1U);
      for (uint16_t id = 0; platforms::PlatformSensor & sensor : platform->sensors) {
        sensor.id = id++;
      }
    }
    const uint32_t library =
        run.sources.add("standard.mission", readSource("missions/library/standard.mission"));
    const auto standard = frontend::parse(run.sources, library, run.diagnostics);
    const auto mission = run.parse();
    return analyse(*mission, {*platform, {&*standard}, run.sources}, run.diagnostics);
  }
  std::optional<ir::Mission> compile(const std::string& text) {
    FrontendRun run(text);
    auto mission = compile(run);
    EXPECT_TRUE(mission.has_value()) << run.said();
    warned_ = run.says(support::diagnostics::declinationUnknown);
    return mission;
  }
  bool warned_ = false;
};

TEST_P(Declination, HeadingsWithoutALine) {
  for (const auto& [route, guard] : {std::pair("heading(90 deg)", "missiontime > 1 h"),
                                     std::pair("nav(39 N, 73 W)", "heading > 90 deg"),
                                     std::pair("noheading", "c_heading > 90 deg"),
                                     std::pair("circle(39 N 73 W, 1 km)", "missiontime > 1 h")}) {
    SCOPED_TRACE(route);
    const auto mission = compile(missionOn("", route, guard));
    ASSERT_TRUE(mission && mission->compass);
    EXPECT_EQ(warned_, !GetParam());
    EXPECT_EQ(mission->compass->variation.valid(), GetParam());
    EXPECT_FALSE(mission->compass->declination.has_value());
    if (GetParam()) {
      EXPECT_EQ((*mission)[mission->compass->variation].vehicle_name, "m_gps_mag_var");
    }
  }
}

TEST_P(Declination, ALineCountsAndNothingIsWarnedOf) {
  const auto mission = compile(missionOn("declination -12 deg", "heading(90 deg)"));
  ASSERT_TRUE(mission && mission->compass);
  EXPECT_FALSE(warned_);
  EXPECT_DOUBLE_EQ(*mission->compass->declination, -12 * 3.141592653589793 / 180);
}

TEST_P(Declination, PositionsNeedNone) {
  const auto mission = compile(missionOn("", "nav(39 N, 73 W)", "bearing(39 N 73 W) > 1"));
  ASSERT_TRUE(mission.has_value());
  EXPECT_FALSE(mission->compass.has_value());
  EXPECT_FALSE(warned_);
  EXPECT_TRUE(std::ranges::none_of(
      mission->sensors, [](const ir::Sensor& s) { return s.vehicle_name == "m_gps_mag_var"; }));
}

TEST_P(Declination, ARouteInCMayCommandAHeading) {
  FrontendRun run(missionOn("extern flightroute spiral", "spiral"));
  const auto mission = compile(run);
  ASSERT_TRUE(mission.has_value()) << run.said();
  EXPECT_TRUE(mission->compass.has_value());
}

TEST_P(Declination, OnlyTheVehiclesHeadingsAreMagnetic) {
  const auto mission =
      compile(missionOn("", "noheading", "heading + c_heading + pitch + roll > 90 deg"));
  ASSERT_TRUE(mission.has_value());
  for (const ir::Sensor& s : mission->sensors) {
    const bool magnetic = s.vehicle_name == "m_heading" || s.vehicle_name == "c_heading";
    EXPECT_EQ(s.encoding == ir::Encoding::Magnetic, magnetic) << s.vehicle_name;
  }
}

INSTANTIATE_TEST_SUITE_P(OfTheVehicle, Declination, testing::Bool());

}  // namespace
}  // namespace glider::frontend
