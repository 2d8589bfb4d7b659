// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/heard_ticks.h"

#include <gtest/gtest.h>

namespace glider::flights {
namespace {

/// A mission whose sensors are 7 and 9 where it is compiled, and 9, 7, 3 in its IR.
class HeardTicksTest : public testing::Test {
 protected:
  HeardTicksTest() {
    for (const uint16_t id : {uint16_t{9}, uint16_t{7}, uint16_t{3}}) {
      ir::Sensor sensor;
      sensor.id = id;
      ir_.sensors.push_back(sensor);
    }
    infos_[0].id = 7;
    infos_[1].id = 9;
    mission_.sensors = infos_;
    mission_.sensor_count = 2;
    context_.mission = &mission_;
    context_.readings = readings_;
  }

  void hear(int sensor, double raw) {
    readings_[sensor].seen = 1;
    readings_[sensor].raw = raw;
    readings_[sensor].updated = context_.mission_time;
  }

  ir::Mission ir_;
  GliderSensorInfo infos_[2]{};
  GliderReading readings_[2]{};
  GliderMission mission_{};
  GliderContext context_{};
};

TEST_F(HeardTicksTest, EachTickHasWhatCameWithIt) {
  HeardTicks heard(ir_);
  hear(0, 12.5);
  heard.look(context_, 100);
  heard.look(context_, 101);  // polled again in the same tick
  context_.mission_time = 4;
  hear(1, -3);
  heard.look(context_, 104);
  context_.mission_time = 8;
  heard.look(context_, 108);
  ASSERT_EQ(heard.ticks().size(), 3U);
  const HeardTick& first = heard.ticks()[0];
  EXPECT_EQ(first.mission_time, 0);
  EXPECT_EQ(first.vehicle_time, 100);
  ASSERT_EQ(first.frame.size(), 1U) << "a sensor that was never seen is not in the first tick";
  EXPECT_EQ(first.frame[0].sensor.index, 1U) << "by its number on the wire";
  EXPECT_EQ(first.frame[0].raw, 12.5);
  const HeardTick& second = heard.ticks()[1];
  ASSERT_EQ(second.frame.size(), 1U);
  EXPECT_EQ(second.frame[0].sensor.index, 0U);
  EXPECT_EQ(second.frame[0].raw, -3);
  EXPECT_TRUE(heard.ticks()[2].frame.empty()) << "a tick of the clock alone";
  EXPECT_EQ(heard.ticks()[2].vehicle_time, 108);
}

TEST_F(HeardTicksTest, EndsWithTheFirstMission) {
  HeardTicks heard(ir_);
  context_.mission_time = 40;
  heard.look(context_, 40);
  context_.mission_time = 4;  // another mission has begun
  heard.look(context_, 60);
  context_.mission_time = 80;
  heard.look(context_, 140);
  EXPECT_EQ(heard.ticks().size(), 1U);
}

TEST_F(HeardTicksTest, SensorsThatTheIrDoesNotHaveAreLeftOut) {
  infos_[0].id = 77;
  HeardTicks heard(ir_);
  hear(0, 1);
  hear(1, 2);
  heard.look(context_, 0);
  ASSERT_EQ(heard.ticks().at(0).frame.size(), 1U);
  EXPECT_EQ(heard.ticks()[0].frame[0].sensor.index, 0U);
}

}  // namespace
}  // namespace glider::flights
