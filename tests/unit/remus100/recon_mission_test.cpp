// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What the compiler writes into a program that steers by RECON.

#include "codegen/seat_mission.h"
#include "platforms/load/load_platform.h"
#include "runtime/recon/readings.h"
#include "support/diagnostics/diagnostic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>
#include <set>
#include <string>

namespace glider::codegen {
namespace {

platforms::Platform platformOf(const std::string& name) {
  auto platform = platforms::loadPlatform(GLIDER_SOURCE_DIR "/platforms/" + name + ".toml");
  EXPECT_TRUE(platform.has_value());
  return *platform;
}

TEST(ReconMission, HasTheLimitsAndTheSensorsOfThePlatform) {
  platforms::Platform remus = platformOf("remus100");
  EXPECT_TRUE(speaksRecon(remus));
  EXPECT_FALSE(speaksImc(remus));
  EXPECT_FALSE(speaksRecon(platformOf("lauv")));
  EXPECT_FALSE(speaksRecon(platformOf("slocum")));
  const auto recon = reconMissionOf(remus);
  ASSERT_TRUE(recon.has_value());
  EXPECT_EQ(recon->greatest_depth_m, 100);
  EXPECT_EQ(recon->slowest_m_s, 0.8);
  EXPECT_EQ(recon->fastest_m_s, 2.5);
  EXPECT_EQ(recon->usual_m_s, 1.5);
  EXPECT_EQ(recon->count, runtime::recon::kReadings) << "each source has its sensor";
  std::set<uint16_t> sources;
  for (uint32_t i = 0; i < recon->count; ++i) {
    EXPECT_TRUE(sources.insert(recon->sources[i]).second) << "two sensors of one source";
    EXPECT_LT(recon->sources[i], runtime::recon::kReadings);
    const auto& sensor = remus.sensors.at(recon->sensors[i]);
    EXPECT_EQ(sensor.source == "state.depth",
              recon->sources[i] == static_cast<uint16_t>(runtime::recon::Reading::Depth));
  }
  for (const char* role : {"Clock", "Depth", "WaterTemperature", "MissionTime", "HookState"}) {
    EXPECT_EQ(std::ranges::count(remus.sensors, role, &platforms::PlatformSensor::role), 1) << role;
  }
}

TEST(ReconMission, ASourceOfAnotherVehicleIsAnError) {
  platforms::Platform remus = platformOf("remus100");
  remus.sensors.front().source = "EstimatedState.depth";
  const auto recon = reconMissionOf(remus);
  ASSERT_FALSE(recon.has_value());
  EXPECT_EQ(support::code(recon.error().id), "GL5001");
  EXPECT_THAT(recon.error().message, ::testing::HasSubstr("no message has `EstimatedState.depth`"));
}

}  // namespace
}  // namespace glider::codegen
