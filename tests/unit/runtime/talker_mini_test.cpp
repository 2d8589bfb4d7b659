// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Messages that are mini packets: sent without a cycle, received as the others.

#include "tests/unit/runtime/talker_bench.h"

#include <gtest/gtest.h>

#include <cmath>
#include <gmock/gmock.h>

namespace glider::runtime::testing {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

void echoes(ScriptedModem& modem, const std::string& body) {
  body.starts_with("CCMUC,") ? modem.say("CAMUC," + body.substr(6))
                             : ScriptedModem::usual(modem, body);
}

/// The first message is one of depths from 0 to 100 m, a mini packet with the signature 0xA5, of
/// which the low three bits are 5.
class TalkerMini : public TalkerTest {
 protected:
  TalkerMini() {
    talk_.shares[0] = {0, 1, 101, kDepth, GLIDER_NO_PLACE, kPeerTop};
    talk_.shares[1] = talk_.shares[2];
    talk_.share_count = 2;
    talk_.messages[0] = {60, 0, 1, 0xA5, GLIDER_MINI_PACKET};
    talk_.messages[1] = {600, 1, 1, 0x5A, 3};
    talk_.named_count = 2;
    modem_.answer = echoes;
    make(1, 3);
  }

  void hear(const std::string& body) {
    modem_.say(body);
    run(5);
  }
  [[nodiscard]] double peer() const { return context_->readings[kPeerTop].value; }
};

TEST_F(TalkerMini, IsSentInItsSlotWithoutACycle) {
  run(600);
  const auto minis = modem_.heardOf("CCMUC");
  ASSERT_THAT(minis, SizeIs(8)) << "a slot every 36 s: a message of every 60 s is sent every 72 s";
  EXPECT_EQ(minis[0], "CCMUC,1,0,0045") << "5 + 8 (7 + 1)";
  EXPECT_THAT(modem_.heardOf("CCCYC"), SizeIs(1)) << "of the other message";
  for (const double time : timesOf("CCMUC")) {
    EXPECT_EQ(std::fmod(std::floor(time / kSlot), 3), 0) << time;
    EXPECT_LE(std::fmod(time, kSlot), 4) << time;
  }
  EXPECT_EQ(talker_->counts().sent, 9U);
  EXPECT_EQ(talker_->counts().unanswered, 0U);
}

TEST_F(TalkerMini, AnUnknownValueIsSentAsSuch) {
  depth_ = 150;
  run(60);
  ASSERT_THAT(modem_.heardOf("CCMUC"), SizeIs(1));
  EXPECT_EQ(modem_.heardOf("CCMUC")[0], "CCMUC,1,0,0005");
}

TEST_F(TalkerMini, WithoutAnEchoItIsGivenUp) {
  modem_.answer = ScriptedModem::usual;
  run(50);
  EXPECT_THAT(modem_.heardOf("CCMUC"), SizeIs(1));
  EXPECT_EQ(talker_->counts().sent, 0U);
  EXPECT_EQ(talker_->counts().unanswered, 1U);
  EXPECT_THAT(modem_.heardOf("CCCFG"), SizeIs(2)) << "the modem may have lost its address";
}

TEST_F(TalkerMini, ARefusalEndsIt) {
  modem_.answer = [](ScriptedModem& modem, const std::string& body) {
    body.starts_with("CCMUC,") ? modem.say("CAERR,120000,MUC") : ScriptedModem::usual(modem, body);
  };
  run(45);
  EXPECT_EQ(talker_->counts().sent, 0U);
  EXPECT_EQ(talker_->counts().unanswered, 1U);
}

/// It was not given to the modem: the next slot of this vehicle comes 36 s later.
TEST_F(TalkerMini, WhatWasRefusedIsSentInTheNextSlot) {
  talk_.messages[0].period = 3600;
  bool refuses = true;
  modem_.answer = [&refuses](ScriptedModem& modem, const std::string& body) {
    body.starts_with("CCMUC,") && refuses ? modem.say("CAERR,120000,MUC") : echoes(modem, body);
    refuses = refuses && !body.starts_with("CCMUC,");
  };
  run(100);
  const auto times = timesOf("CCMUC");
  ASSERT_THAT(times, SizeIs(2));
  EXPECT_NEAR(times[1] - times[0], 36, 3);
  EXPECT_EQ(talker_->counts().sent, 1U);
}

/// A line that takes nothing until later: what is late would be in the slot of another vehicle.
TEST_F(TalkerMini, WhatTheLineDoesNotTakeIsDropped) {
  run(30);
  const size_t before = modem_.heardOf("CCMUC").size();
  modem_.takes = 0;
  run(90);
  EXPECT_EQ(modem_.heardOf("CCMUC").size(), before);
  EXPECT_GE(talker_->counts().unanswered, 1U);
  modem_.takes = 1000;
  run(60);
  for (const double time : timesOf("CCMUC")) {
    EXPECT_EQ(std::fmod(std::floor(time / kSlot), 3), 0) << time;
    EXPECT_LE(std::fmod(time, kSlot), 4 + Talker::kLongestDialogueSecs + 1) << time;
  }
}

/// An echo of another mini packet is not that of ours.
TEST_F(TalkerMini, AnotherEchoIsNotOurs) {
  modem_.answer = [](ScriptedModem& modem, const std::string& body) {
    body.starts_with("CCMUC,") ? modem.say("CAMUC,1,0,0046") : ScriptedModem::usual(modem, body);
  };
  run(45);
  EXPECT_EQ(talker_->counts().sent, 0U);
}

/// An echo without a mini packet of ours counts nothing.
TEST_F(TalkerMini, AnEchoOutOfTurnCountsNothing) {
  run(40);
  const uint32_t sent = talker_->counts().sent;
  hear("CAMUC,1,0,0045");
  EXPECT_EQ(talker_->counts().sent, sent);
}

TEST_F(TalkerMini, IsReceived) {
  run(41);
  hear("CAMUA,2,0,015D");  // 5 + 8 (42 + 1)
  EXPECT_EQ(peer(), 42);
  EXPECT_EQ(context_->readings[kSecondTop].value, 42);
  EXPECT_TRUE(std::isnan(context_->readings[kThirdTop].value));
  hear("CAMUA,3,1,0025");
  EXPECT_EQ(peer(), 3);
  EXPECT_EQ(context_->readings[kThirdTop].value, 3);
  hear("CAMUA,3,0,0005");
  EXPECT_EQ(peer(), 3) << "the sender did not know it";
  EXPECT_EQ(talker_->counts().received, 3U);
  EXPECT_EQ(talker_->counts().refused, 0U);
}

TEST_F(TalkerMini, OfOthersIsRefused) {
  run(41);
  for (const char* body : {
           "CAMUA,2,0,015C",  // another signature
           "CAMUA,2,0,0335",  // the digit 102: the greatest is 101
           "CAMUA,2,0,1FFD",
           "CAMUA,1,0,015D",  // the own address
           "CAMUA,0,0,015D",  // no vehicle's
       }) {
    const uint32_t refused = talker_->counts().refused;
    hear(body);
    EXPECT_EQ(talker_->counts().refused, refused + 1) << body;
  }
  hear("CAMUA,2,3,015D");  // for another vehicle
  hear("CAMUC,2,0,015D");  // an echo
  hear("CCMUC,2,0,015D");  // a host
  EXPECT_TRUE(std::isnan(peer()));
  EXPECT_EQ(talker_->counts().received, 0U);
  hear("CAMUA,2,0,032D");
  EXPECT_EQ(peer(), 100) << "the digit 101";
}

/// The second message has 1001 values, which would fit a mini packet with its signature: 2.
TEST_F(TalkerMini, AMiniPacketIsNoFrame) {
  run(41);
  hear("CAMUA,2,0,002A");
  EXPECT_EQ(talker_->counts().received, 0U);
  EXPECT_EQ(talker_->counts().refused, 1U);
}

/// What is a frame in one mission is a mini packet in another: neither is taken for the other.
TEST_F(TalkerMini, AFrameIsNoMiniPacket) {
  talk_.messages[0].signature = 0;  // that of a frame without data
  run(41);
  hear("CARXD,2,0,0,1,");
  hear("CARXD,2,0,0,1,5D01");
  hear("CARXD,2,0,0,1,A52B");  // 0xA5 + 256 * 43
  EXPECT_TRUE(std::isnan(peer()));
  EXPECT_EQ(talker_->counts().received, 0U);
}

}  // namespace
}  // namespace glider::runtime::testing
