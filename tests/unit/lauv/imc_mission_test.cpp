// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What the compiler writes into a program that steers by IMC, and the sensors of its seat.

#include "codegen/seat_mission.h"
#include "platforms/load/load_platform.h"
#include "platforms/load/seat_sensors.h"
#include "runtime/imc/readings.h"
#include "support/diagnostics/diagnostic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>
#include <set>
#include <string>

namespace glider::codegen {
namespace {

using testing::HasSubstr;

platforms::Platform platformOf(const std::string& name) {
  auto platform = platforms::loadPlatform(GLIDER_SOURCE_DIR "/platforms/" + name + ".toml");
  EXPECT_TRUE(platform.has_value());
  return *platform;
}
platforms::PlatformSensor& sensorOf(platforms::Platform& platform, const std::string& source) {
  const auto found =
      std::ranges::find(platform.sensors, source, &platforms::PlatformSensor::source);
  EXPECT_NE(found, platform.sensors.end()) << source;
  return *found;
}

TEST(ImcMission, HasTheLimitsAndTheSensorsOfThePlatform) {
  platforms::Platform lauv = platformOf("lauv");
  EXPECT_TRUE(speaksImc(lauv));
  EXPECT_FALSE(speaksImc(platformOf("slocum")));
  const auto imc = imcMissionOf(lauv);
  ASSERT_TRUE(imc.has_value());
  EXPECT_EQ(imc->greatest_depth_m, 50);
  EXPECT_EQ(imc->slowest_m_s, 0.7);
  EXPECT_EQ(imc->fastest_m_s, 1.6);
  EXPECT_EQ(imc->usual_m_s, 1.2);
  EXPECT_EQ(imc->start_depth_m, 2);
  EXPECT_EQ(imc->timeout_s, 15);
  bool depth = false;
  std::set<uint16_t> sources;
  for (uint32_t i = 0; i < imc->count; ++i) {
    depth = depth || (imc->sensors[i] == sensorOf(lauv, "EstimatedState.depth").id &&
                      imc->sources[i] == static_cast<uint16_t>(runtime::imc::Reading::Depth));
    EXPECT_FALSE(lauv.sensors.at(imc->sensors[i]).source.empty());
    EXPECT_LT(imc->sources[i], runtime::imc::kReadings);
    EXPECT_TRUE(sources.insert(imc->sources[i]).second) << "two sensors of one source";
  }
  EXPECT_TRUE(depth);
  EXPECT_EQ(imc->count, std::ranges::count_if(lauv.sensors, [](const auto& sensor) {
              return !sensor.source.empty();
            }));
}

TEST(ImcMission, ASourceThatNoMessageHasIsAnError) {
  platforms::Platform lauv = platformOf("lauv");
  sensorOf(lauv, "EstimatedState.depth").source = "EstimatedState.height";
  const auto imc = imcMissionOf(lauv);
  ASSERT_FALSE(imc.has_value());
  EXPECT_EQ(support::code(imc.error().id), "GL5001");
  EXPECT_THAT(imc.error().message, HasSubstr("no message has `EstimatedState.height`"));
}

TEST(ImcMission, AnotherUnitIsAnError) {
  platforms::Platform lauv = platformOf("lauv");
  sensorOf(lauv, "EstimatedState.depth").unit = "ft";
  const auto imc = imcMissionOf(lauv);
  ASSERT_FALSE(imc.has_value());
  EXPECT_THAT(imc.error().message, HasSubstr("must be \"m\""));
}

TEST(ImcMission, TheSeatHasEachOfItsSensorsOnce) {
  platforms::Platform lauv = platformOf("lauv");
  for (const char* role : {"MissionTime", "HookState", "HookCheck", "HookSequence"}) {
    EXPECT_EQ(std::ranges::count(lauv.sensors, role, &platforms::PlatformSensor::role), 1) << role;
  }
  for (size_t i = 0; i < lauv.sensors.size(); ++i) {
    EXPECT_EQ(lauv.sensors[i].id, i);
  }
  const size_t before = lauv.sensors.size();
  platforms::addSeatSensors(lauv);
  EXPECT_EQ(lauv.sensors.size(), before) << "it has them";
  std::erase_if(lauv.sensors, [](const auto& sensor) { return sensor.role == "HookState"; });
  platforms::addSeatSensors(lauv);
  EXPECT_EQ(lauv.sensors.size(), before);
  EXPECT_EQ(lauv.sensors.back().role, "HookState");
}

}  // namespace
}  // namespace glider::codegen
