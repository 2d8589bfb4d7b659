// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What is received of others, and that nothing else of the mission depends on it.

#include "tests/unit/runtime/talker_bench.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <random>

namespace glider::runtime::testing {
namespace {

using TalkerReceives = TalkerTest;

TEST_F(TalkerReceives, WhatIsReceivedComesWithTheNextFrame) {
  run(41);
  const std::string hex = hexOf(talk_, 0, {12.5, 1});
  modem_.say("CARXD,2,0,0,1," + hex);
  poll();
  EXPECT_EQ(talker_->counts().received, 1U);
  EXPECT_TRUE(std::isnan(context_->readings[kPeerTop].value));
  EXPECT_EQ(context_->readings[kPeerTop].seen, 0U);
  // A tick without a frame of the vehicle takes nothing in.
  gliderStep(context_, context_->mission_time + 1, nullptr, 0);
  EXPECT_TRUE(std::isnan(context_->readings[kPeerTop].value));
  tick();
  EXPECT_EQ(context_->readings[kPeerTop].value, 12.5);
  EXPECT_EQ(context_->readings[kPeerFound].value, 1);
  EXPECT_EQ(context_->readings[kPeerTop].updated, context_->mission_time);
  EXPECT_EQ(context_->readings[kPeerTop].waiting, 0U);
  const double then = context_->mission_time;
  run(100);
  EXPECT_EQ(context_->readings[kPeerTop].updated, then) << "once";
  run(600);
  EXPECT_TRUE(std::isnan(context_->readings[kPeerTop].value)) << "it is old";
}

/// Its age would be counted from the frame that it came with.
TEST_F(TalkerReceives, WhatWaitsTooLongForAFrameIsDropped) {
  for (const double wait_s : {Talker::kLongestWaitSecs - 2, Talker::kLongestWaitSecs + 2}) {
    run(41);
    modem_.say("CARXD,2,0,0,1," + hexOf(talk_, 0, {wait_s / 2, 1}));
    flies_ = false;
    run(wait_s);
    flies_ = true;
    run(kCycle);
    EXPECT_EQ(context_->readings[kPeerTop].value, (Talker::kLongestWaitSecs - 2) / 2) << wait_s;
  }
}

TEST_F(TalkerReceives, WhatTheSenderDidNotKnowChangesNothing) {
  run(41);
  modem_.say("CARXD,2,0,0,1," + hexOf(talk_, 0, {12.5, 1}));
  run(5);
  modem_.say("CARXD,3,0,0,1," + hexOf(talk_, 0, {kNan, 0}));
  run(5);
  EXPECT_EQ(context_->readings[kPeerTop].value, 12.5);
  EXPECT_EQ(context_->readings[kPeerFound].value, 0);
}

TEST_F(TalkerReceives, WhatAVehicleTellsIsKeptByItsName) {
  run(41);
  const auto value = [&](uint32_t place) { return context_->readings[place].value; };
  modem_.say("CARXD,2,0,0,1," + hexOf(talk_, 0, {12.5, 1}));
  run(5);
  EXPECT_EQ(value(kSecondTop), 12.5);
  EXPECT_TRUE(std::isnan(value(kThirdTop))) << "it has said nothing";
  EXPECT_TRUE(std::isnan(value(kThirdFound)));
  modem_.say("CARXD,3,0,0,1," + hexOf(talk_, 0, {20, kNan}));
  run(5);
  EXPECT_EQ(value(kSecondTop), 12.5) << "another has spoken since";
  EXPECT_EQ(value(kThirdTop), 20);
  EXPECT_TRUE(std::isnan(value(kThirdFound))) << "it does not know it";
  EXPECT_EQ(value(kPeerTop), 20) << "the newest of any";
  EXPECT_EQ(value(kPeerFound), 1) << "of the second";
}

TEST_F(TalkerReceives, AVehicleOutsideTheLineIsOnlyAnyPeer) {
  run(41);
  modem_.say("CARXD,4,0,0,1," + hexOf(talk_, 0, {12.5, 1}));
  modem_.say("CARXD,1,0,0,1," + hexOf(talk_, 0, {50, 1}));  // its own address
  run(5);
  EXPECT_EQ(context_->readings[kPeerTop].value, 12.5);
  for (const uint32_t place : {kSecondTop, kThirdTop, kThirdFound}) {
    EXPECT_EQ(context_->readings[place].seen, 0U) << place;
  }
}

TEST_F(TalkerReceives, TheSameNumbersOfAnotherMessageAreOfAnotherShare) {
  talk_.named[2] = {kThirdFound, 2, 3};
  run(41);
  modem_.say("CARXD,3,0,0,1," + hexOf(talk_, 0, {12.5, 1}));
  run(5);
  EXPECT_EQ(context_->readings[kThirdFound].seen, 0U);
  modem_.say("CARXD,3,0,0,1," + hexOf(talk_, 1, {1}));
  run(5);
  EXPECT_EQ(context_->readings[kThirdFound].value, 1);
}

TEST_F(TalkerReceives, WhatANamedVehicleSaidTooLongAgoIsDropped) {
  run(41);
  modem_.say("CARXD,3,0,0,1," + hexOf(talk_, 0, {12.5, 1}));
  poll();
  ASSERT_EQ(context_->readings[kThirdTop].waiting, 1U);
  flies_ = false;
  run(Talker::kLongestWaitSecs - 2);
  EXPECT_EQ(context_->readings[kThirdTop].waiting, 1U);
  run(4);
  EXPECT_EQ(context_->readings[kThirdTop].waiting, 0U);
  EXPECT_EQ(context_->readings[kThirdFound].waiting, 0U);
  EXPECT_EQ(context_->readings[kPeerTop].waiting, 0U);
}

TEST_F(TalkerReceives, WhatHasNoRoomInAFrameWaits) {
  run(41);
  modem_.say("CARXD,2,0,0,1," + hexOf(talk_, 0, {12.5, 1}));
  poll();
  std::vector<GliderUpdate> frame(hooks::kMostSubscriptions, update(GLIDER_M_DEPTH, 1));
  const auto all = static_cast<uint32_t>(frame.size());
  EXPECT_EQ(gliderHear(&mission_.mission, context_, &variation_, frame.data(), all), all);
  EXPECT_EQ(gliderHear(&mission_.mission, context_, &variation_, frame.data(), all - 1), all);
  EXPECT_EQ(frame.back().id, 0xFE00U);
  EXPECT_EQ(context_->readings[kPeerTop].waiting, 0U);
  EXPECT_EQ(context_->readings[kPeerFound].waiting, 1U);
  EXPECT_EQ(gliderHear(&mission_.mission, context_, &variation_, nullptr, 0), 0U);
  EXPECT_EQ(gliderHear(&mission_.mission, nullptr, &variation_, frame.data(), 3), 3U);
  EXPECT_EQ(context_->readings[kPeerFound].waiting, 1U);
}

TEST_F(TalkerReceives, HeadingsAreStillConverted) {
  run(41);
  mission_.sensors.push_back(
      {"m_heading", nullptr, 1, 0, 6.3, 20, GLIDER_M_HEADING, kGliderMagnetic});
  GliderMission mission = mission_.mission;
  mission.sensors = mission_.sensors.data();
  const GliderCompass compass{-0.25, GLIDER_NO_SENSOR, 0, gliderHearAndConvertHeadings};
  mission.compass = &compass;
  context_->readings[kPeerTop].raw = 9;
  context_->readings[kPeerTop].waiting = 1;
  mission.sensor_count = static_cast<uint32_t>(mission_.sensors.size());
  std::vector<GliderUpdate> frame(hooks::kMostSubscriptions, update(GLIDER_M_HEADING, 1));
  context_->variation = kNan;
  ASSERT_EQ(gliderHearAndConvertHeadings(&mission, context_, &variation_, frame.data(), 1), 2U);
  EXPECT_EQ(frame[0].value, 0.75);
  EXPECT_EQ(frame[1].value, 9);
}

TEST_F(TalkerReceives, FramesThatAreNotOfTheFleetAreRefused) {
  run(41);
  const std::string good = hexOf(talk_, 0, {12.5, 1});
  for (const std::string& frame :
       {"2,0,0,1,A4" + good.substr(2), "2,0,0,1," + good + "00", "2,0,0,1," + good.substr(0, 4),
        std::string("2,0,0,1,"), std::string("2,0,0,1,A5FFFF"), "1,0,0,1," + good,
        "0,0,0,1," + good}) {
    const uint32_t before = talker_->counts().refused;
    modem_.say("CARXD," + frame);
    run(1);
    EXPECT_EQ(talker_->counts().refused, before + 1) << frame;
  }
  modem_.say("CARXD,2,5,0,1," + good);  // for another
  modem_.say("CAMSG,BAD_CRC,1");
  modem_.say("CAMSG,Bad CRC,1");
  run(1);
  EXPECT_EQ(talker_->counts().received, 0U);
  EXPECT_EQ(talker_->counts().refused, 7U);
  EXPECT_EQ(talker_->counts().damaged, 2U);
  EXPECT_EQ(context_->readings[kPeerTop].waiting, 0U);
  modem_.say("CARXD,2,1,0,1," + good);
  run(1);
  EXPECT_EQ(talker_->counts().received, 1U);
}

/// The mission's memory except for what is received.
std::vector<double> memoryOf(const BenchMission& mission, GliderContext* context) {
  for (const uint32_t place : {kPeerTop, kPeerFound, kSecondTop, kThirdTop, kThirdFound}) {
    context->readings[place] = {};
  }
  return mission.memory;
}

TEST_F(TalkerReceives, APeerThatLiesOnlyGivesValuesOfTheScales) {
  run(42);
  std::mt19937 rng(3);
  const std::vector<double> before = memoryOf(mission_, context_);
  uint32_t taken = 0;
  for (int i = 0; i < 20000; ++i) {
    char hex[16];
    const auto number = static_cast<unsigned>(rng() % 0x600);  // 402 times 3 are messages
    std::snprintf(hex, sizeof hex, "A5%02X%02X", number & 0xFFU, number >> 8U);
    modem_.say("CARXD,2,0,0,1," + std::string(hex));
    poll();
    const GliderReading& top = context_->readings[kPeerTop];
    const GliderReading& found = context_->readings[kPeerFound];
    EXPECT_TRUE(top.waiting == 0 ||
                (top.raw >= 0 && top.raw <= 200 && top.raw * 2 == std::floor(top.raw * 2)));
    EXPECT_TRUE(found.waiting == 0 || found.raw == 0 || found.raw == 1);
    taken += top.waiting;
    std::ignore = memoryOf(mission_, context_);
  }
  EXPECT_GT(taken, 10000U);
  EXPECT_GT(talker_->counts().refused, 100U);
  EXPECT_EQ(memcmp(before.data(), mission_.memory.data(), before.size() * sizeof(double)), 0);
}

TEST_F(TalkerReceives, RubbishDoesNoHarm) {
  run(42);
  std::mt19937 rng(4);
  const std::vector<double> before = memoryOf(mission_, context_);
  const std::vector<std::string> pieces{"$",
                                        "*",
                                        ",",
                                        "\r\n",
                                        "CA",
                                        "CADRQ",
                                        "CARXD",
                                        "CACYC,0,1",
                                        "$CAREV,",
                                        "CACFG,SRC,1",
                                        "1",
                                        "0,0",
                                        std::string("\0\xFF", 2)};
  for (int i = 0; i < 20000; ++i) {
    modem_.bytes(pieces[rng() % pieces.size()]);
    if (i % 16 == 0) {
      now_ += 0.001;
      poll();
    }
  }
  EXPECT_EQ(memcmp(before.data(), mission_.memory.data(), before.size() * sizeof(double)), 0);
  EXPECT_GT(talker_->badSentences(), 100U);
  run(200);
  EXPECT_GT(talker_->counts().sent, 0U) << "it still does what it is for";
}

}  // namespace
}  // namespace glider::runtime::testing
