// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The dialogue with an acoustic modem: when a vehicle sends, what it takes, and that nothing else
// of the mission depends on it.

#include "runtime/talk/talker.h"

#include "hooks/protocol/tick.h"
#include "hooks/share/message.h"
#include "tests/unit/runtime/bench_mission.h"
#include "tests/unit/runtime/scripted_modem.h"

#include <gtest/gtest.h>

#include <cmath>
#include <gmock/gmock.h>
#include <limits>
#include <memory>
#include <random>

namespace glider::runtime::testing {
namespace {

using hooks::share::MessageWriter;
using talk::Talker;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr uint32_t kDepth = 0, kUtc = 1, kPeerTop = 2, kPeerFound = 3;  // places
constexpr uint32_t kFound = 0;
constexpr double kSlot = 12, kCycle = 4;
constexpr double kMidnight = 47222220.0 * 36;  // a slot of the first of three vehicles begins

GliderSensorInfo received(const char* name, uint32_t id, double highest) {
  return {name, gliderNothingHeard, 1, 0, highest, 600, id, kGliderLinear};
}

/// Depth every minute, with whether something was found; nothing else every ten.
GliderTalk benchTalk() {
  GliderTalk talk{};
  talk.slot_s = kSlot;
  talk.utc = kUtc;
  talk.begin_within_ms = 4000;
  talk.share_count = 3;
  talk.shares[0] = {0, 0.5, 401, kDepth, GLIDER_NO_PLACE, kPeerTop};
  talk.shares[1] = {0, 1, 2, GLIDER_NO_PLACE, kFound, kPeerFound};
  talk.shares[2] = {-100, 1, 1001, kDepth, GLIDER_NO_PLACE, GLIDER_NO_PLACE};
  talk.message_count = 2;
  talk.messages[0] = {60, 0, 2, 0xA5, 3};
  talk.messages[1] = {600, 2, 1, 0x5A, 3};
  return talk;
}

/// A message as another vehicle sends it.
std::string hexOf(const GliderTalk& talk, uint32_t message, const std::vector<double>& values) {
  MessageWriter writer;
  for (size_t i = values.size(); i != 0; --i) {
    const GliderShare& share = talk.shares[talk.messages[message].first + i - 1];
    writer.put({share.lowest, share.step, share.values}, values[i - 1]);
  }
  uint8_t bytes[32];
  EXPECT_TRUE(writer.end(static_cast<uint8_t>(talk.messages[message].signature), bytes,
                         talk.messages[message].bytes));
  std::string hex;
  for (uint32_t i = 0; i < talk.messages[message].bytes; ++i) {
    char two[3];
    std::snprintf(two, sizeof two, "%02X", bytes[i]);
    hex += two;
  }
  return hex;
}

class TalkerTest : public ::testing::Test {
 protected:
  TalkerTest() {
    mission_.sensors = {
        depthSensor(),
        {"m_present_time", nullptr, 1, 0, 4e9, 20, GLIDER_M_PRESENT_TIME, kGliderLinear},
        received("peer.top", 0xFE00, 200),
        received("peer.found", 0xFE01, 1)};
    mission_.states = {benchState("only", nullptr, 0)};
    mission_.variable_count = 1;
    mission_.finish(1);
    make(1, 3);
  }

  void make(uint32_t address, uint32_t vehicles) {
    talker_ = std::make_unique<Talker>(talk_, address, vehicles);
  }

  /// A tick of the mission with its frame, as the runtime does it.
  void tick() {
    std::vector<GliderUpdate> frame{update(GLIDER_M_DEPTH, depth_)};
    if (reports_utc_) {
      frame.push_back(update(GLIDER_M_PRESENT_TIME, utc()));
    }
    auto count = static_cast<uint32_t>(frame.size());
    frame.resize(hooks::kMostSubscriptions);
    count = gliderHear(&mission_.mission, context_, &variation_, frame.data(), count);
    if (context_ == nullptr) {
      context_ =
          gliderStart(mission_.memory.data(), &mission_.mission, nullptr, frame.data(), count);
      began_ = now_;
    } else {
      gliderStep(context_, now_ - began_, frame.data(), count);
    }
  }
  /// So many seconds, with a tick every cycle.
  void run(double seconds) {
    for (const double end = now_ + seconds; now_ < end;) {
      now_ += 1;
      if (flies_ && std::fmod(now_, kCycle) == 0) {
        tick();
      }
      poll();
    }
  }
  void poll() {
    const size_t before = modem_.heard.size();
    talker_->poll(modem_.stream(), context_, now_ + clock_is_ahead_);
    for (size_t i = before; i < modem_.heard.size(); ++i) {
      said_at_.push_back(utc());
    }
  }
  [[nodiscard]] double utc() const { return kMidnight + now_ + utc_is_ahead_; }
  /// When the sentences that begin so were said.
  std::vector<double> timesOf(const std::string& name) {
    std::vector<double> times;
    for (size_t i = 0; i < said_at_.size(); ++i) {
      if (modem_.heard[i].starts_with(name)) {
        times.push_back(said_at_[i]);
      }
    }
    return times;
  }

  GliderTalk talk_ = benchTalk();
  BenchMission mission_;
  std::unique_ptr<Talker> talker_;
  ScriptedModem modem_;
  GliderContext* context_ = nullptr;
  double now_ = 0, began_ = 0, clock_is_ahead_ = 0, utc_is_ahead_ = 0, depth_ = 7.3;
  double variation_ = kNan;
  bool flies_ = true, reports_utc_ = true;
  std::vector<double> said_at_;
};

TEST_F(TalkerTest, SendsInItsSlot) {
  run(600);
  ASSERT_GE(modem_.heard.size(), 3U);
  EXPECT_EQ(modem_.heard[0], "CCCFG,SRC,1");
  EXPECT_EQ(modem_.heard[1], "CCCYC,0,1,0,0,0,1");
  // 7.3 m is 7.5 m: A5 + 256 (16 + 402 0), since what was found is not known.
  EXPECT_EQ(modem_.heard[2], "CCTXD,1,0,0,A51000");
  EXPECT_THAT(modem_.heardOf("CCCFG"), SizeIs(1));
  for (const double time : timesOf("CCCYC")) {
    EXPECT_EQ(std::fmod(std::floor(time / kSlot), 3), 0) << time;
    EXPECT_LE(std::fmod(time, kSlot), 2) << time;
  }
  EXPECT_EQ(talker_->counts().sent, modem_.heardOf("CCTXD").size());
  EXPECT_EQ(talker_->counts().unanswered, 0U);
}

TEST_F(TalkerTest, SendsWhatTheMissionHasNow) {
  mission_.begin = [](GliderContext& c) { c.variables[kFound] = 1; };
  depth_ = 199.9;
  run(60);
  EXPECT_EQ(modem_.heardOf("CCTXD")[0].substr(12), hexOf(talk_, 0, {200, 1}));
  depth_ = 500;  // told as unknown, never as the end of the scale
  context_->variables[kFound] = 0;
  run(120);
  EXPECT_EQ(modem_.heardOf("CCTXD").back().substr(12), hexOf(talk_, 0, {kNan, 0}));
}

/// A slot of this vehicle comes every 36 s, so a message of every minute is sent every 72 s.
TEST_F(TalkerTest, KeepsThePeriods) {
  run(3600);
  std::vector<double> first, second;
  const auto times = timesOf("CCTXD");
  const auto sentences = modem_.heardOf("CCTXD");
  for (size_t i = 0; i < times.size(); ++i) {
    (sentences[i].substr(12, 2) == "A5" ? first : second).push_back(times[i]);
  }
  EXPECT_NEAR(static_cast<double>(first.size()), 3600 / 72, 4);
  EXPECT_NEAR(static_cast<double>(second.size()), 3600 / 612, 1);
  for (size_t i = 1; i < first.size(); ++i) {
    EXPECT_GE(first[i] - first[i - 1], 60);
  }
  for (size_t i = 1; i < second.size(); ++i) {
    EXPECT_GE(second[i] - second[i - 1], 600);
  }
}

TEST_F(TalkerTest, TheMostOverdueComesFirst) {
  talk_.messages[0].period = 30;  // due in each slot
  talk_.messages[1].period = 40;  // in each second slot
  run(2000);
  const auto sentences = modem_.heardOf("CCTXD");
  size_t second = 0;
  for (const std::string& sentence : sentences) {
    second += sentence.substr(12, 2) == "5A" ? 1U : 0U;
  }
  EXPECT_NEAR(static_cast<double>(second), static_cast<double>(sentences.size()) / 2, 2);
}

TEST_F(TalkerTest, AsksForItsAddressUntilTheModemHasIt) {
  modem_.answer = [](ScriptedModem&, const std::string&) {};
  run(60);
  EXPECT_THAT(modem_.heardOf("CCCFG"), SizeIs(12));
  EXPECT_THAT(modem_.heardOf("CCCYC"), IsEmpty());
  modem_.say("CACFG,SRC,2");
  modem_.say("CACFG,DTO,1");
  run(60);
  EXPECT_THAT(modem_.heardOf("CCCYC"), IsEmpty());
  modem_.answer = ScriptedModem::usual;
  run(60);
  EXPECT_THAT(modem_.heardOf("CCCFG"), SizeIs(25));
  EXPECT_FALSE(modem_.heardOf("CCCYC").empty());
}

TEST_F(TalkerTest, BeforeTheMissionItSendsNothing) {
  flies_ = false;
  run(200);
  EXPECT_THAT(modem_.heard, ElementsAre("CCCFG,SRC,1"));
}

TEST_F(TalkerTest, AfterTheMissionItSendsNothing) {
  run(50);
  context_->finished = 1;
  run(12);
  const size_t before = modem_.heard.size();
  run(400);
  EXPECT_EQ(modem_.heard.size(), before);
}

TEST_F(TalkerTest, WithoutUtcItSendsNothing) {
  reports_utc_ = false;
  run(300);
  EXPECT_THAT(modem_.heard, ElementsAre("CCCFG,SRC,1"));
  reports_utc_ = true;
  run(100);
  EXPECT_FALSE(modem_.heardOf("CCCYC").empty());
}

/// The mission's reading is older than its `stale_after`, 20 s, before this clock gives up.
TEST_F(TalkerTest, WhatTheMissionDoesNotKnowItDoesNotKnow) {
  make(1, 1);
  talk_.messages[0].period = 1;
  run(100);
  reports_utc_ = false;
  run(24);
  const size_t before = modem_.heardOf("CCCYC").size();
  run(60);
  EXPECT_EQ(modem_.heardOf("CCCYC").size(), before);
}

TEST_F(TalkerTest, WhenTheVehicleFallsSilentUtcIsSoonUnknown) {
  run(100);
  flies_ = false;
  run(talk::SlotClock::kMostWithoutReport + 1);
  const size_t before = modem_.heard.size();
  run(400);
  EXPECT_EQ(modem_.heard.size(), before);
}

/// By the tick alone a slot could be missed: a slot of 3 s begins and ends between two frames.
TEST_F(TalkerTest, BetweenFramesUtcGoesOnByTheClock) {
  talk_.slot_s = 3;
  talk_.messages[0].period = 9;
  run(300);
  const auto times = timesOf("CCCYC");
  EXPECT_GE(times.size(), 20U);
  for (const double time : times) {
    EXPECT_EQ(std::fmod(std::floor(time / 3), 3), 0) << time;
  }
}

TEST_F(TalkerTest, AfterAJumpOfUtcTheSlotsAreThoseOfTheNewTime) {
  for (const double jump : {1000.0, -5000.0, 17.0, -3.0}) {
    run(120);
    utc_is_ahead_ += jump;
    run(8 * kCycle + 1);  // of eight reports the one that is least late counts
    const size_t before = said_at_.size();
    run(200);
    const auto times = timesOf("CCCYC");
    ASSERT_GT(said_at_.size(), before);
    for (const double time : times) {
      if (time >= utc() - 200 && time <= utc()) {
        EXPECT_EQ(std::fmod(std::floor(time / kSlot), 3), 0) << jump << ' ' << time;
      }
    }
  }
}

/// A cycle that takes 15 s: its report of UTC is late by that.
TEST_F(TalkerTest, AReportThatIsLateMovesNoSlot) {
  run(120);
  utc_is_ahead_ -= 15;
  run(kCycle);
  utc_is_ahead_ += 15;
  run(400);
  for (const double time : timesOf("CCCYC")) {
    EXPECT_EQ(std::fmod(std::floor(time / kSlot), 3), 0) << time;
  }
}

TEST_F(TalkerTest, AClockThatJumpsDoesNoHarm) {
  run(100);
  for (const double ahead : {-1e6, 1e9, kNan, 0.0}) {
    clock_is_ahead_ = ahead;
    run(300);
    for (const double time : timesOf("CCCYC")) {
      EXPECT_EQ(std::fmod(std::floor(time / kSlot), 3), 0) << ahead << ' ' << time;
    }
  }
  EXPECT_EQ(talker_->counts().sent, modem_.heardOf("CCTXD").size());
}

/// The readings of a checkpoint are of before the outage.
TEST_F(TalkerTest, UtcOfACheckpointIsNotTrusted) {
  run(40);
  const GliderReading old = context_->readings[kUtc];
  now_ += 15;  // the program starts again
  make(1, 3);
  flies_ = false;
  const size_t before = modem_.heard.size();
  run(30);
  EXPECT_EQ(context_->readings[kUtc].updated, old.updated);
  EXPECT_EQ(modem_.heard.size(), before + 1) << "it asks for its address";
  flies_ = true;
  run(60);
  EXPECT_FALSE(modem_.heardOf("CCCYC").empty());
  for (const double time : timesOf("CCCYC")) {
    EXPECT_EQ(std::fmod(std::floor(time / kSlot), 3), 0) << time;
  }
}

TEST_F(TalkerTest, ASlotThatHasBegunLongAgoIsNotUsed) {
  modem_.answer = [](ScriptedModem&, const std::string&) {};
  run(36 + 4);
  modem_.say("CACFG,SRC,1");  // 5 s of its slot have passed when it reads this
  run(36 - 5);
  EXPECT_THAT(modem_.heardOf("CCCYC"), IsEmpty());
  run(5);
  EXPECT_THAT(modem_.heardOf("CCCYC"), SizeIs(1));
}

TEST_F(TalkerTest, ASlotThatHasJustBegunIsUsed) {
  modem_.answer = [](ScriptedModem&, const std::string&) {};
  run(36 + 3);
  modem_.say("CACFG,SRC,1");
  run(1);
  EXPECT_THAT(modem_.heardOf("CCCYC"), SizeIs(1));
}

TEST_F(TalkerTest, ACycleWithoutAnAnswerIsGivenUp) {
  modem_.answer = [](ScriptedModem& modem, const std::string& body) {
    if (body.starts_with("CCCFG")) {
      ScriptedModem::usual(modem, body);
    }
  };
  run(40 + Talker::kPatienceSecs + 2);
  EXPECT_EQ(talker_->counts().unanswered, 1U);
  EXPECT_THAT(modem_.heardOf("CCCFG"), SizeIs(2)) << "the modem may have started again";
  modem_.say("CADRQ,120000,1,0,0,32,1");  // too late
  run(2);
  EXPECT_EQ(modem_.heard.back(), "CCTXD,1,0,0,");
  modem_.answer = ScriptedModem::usual;
  run(72);
  EXPECT_GE(talker_->counts().sent, 1U);
}

TEST_F(TalkerTest, AFrameWithoutAnEndIsGivenUp) {
  modem_.answer = [](ScriptedModem& modem, const std::string& body) {
    if (!body.starts_with("CCTXD")) {
      ScriptedModem::usual(modem, body);
    }
  };
  run(40 + Talker::kPatienceSecs + 2);
  EXPECT_EQ(talker_->counts().unanswered, 1U);
  EXPECT_EQ(talker_->counts().sent, 0U);
}

TEST_F(TalkerTest, ARefusalEndsTheCycleAtOnce) {
  modem_.answer = [](ScriptedModem& modem, const std::string& body) {
    body.starts_with("CCCYC") ? modem.say("CAERR,120000,NMEA,5")
                              : ScriptedModem::usual(modem, body);
  };
  modem_.say("CAERR,120000,NMEA,5");  // of nothing
  run(40);
  EXPECT_EQ(talker_->counts().unanswered, 1U);
}

TEST_F(TalkerTest, CyclesOfOthersAreNotItsOwn) {
  run(50);
  const size_t before = modem_.heard.size();
  modem_.say("CACYC,0,3,0,0,0,1");
  modem_.say("CADRQ,120000,3,0,0,32,1");
  modem_.say("CATXF,32");
  modem_.say("CAACK,3,1,1,1");
  run(2);
  EXPECT_EQ(modem_.heard.size(), before);
}

/// Another host may start a cycle in which this vehicle is asked for data.
TEST_F(TalkerTest, WithoutACycleOfItsOwnItGivesNoData) {
  run(50);
  const auto sent = talker_->counts().sent;
  modem_.say("CADRQ,120000,1,4,1,32,1");
  run(2);
  EXPECT_EQ(modem_.heard.back(), "CCTXD,1,4,1,");
  modem_.say("CATXF,0");
  run(2);
  EXPECT_EQ(talker_->counts().sent, sent);
}

TEST_F(TalkerTest, AFrameWithLessRoomGetsNoData) {
  modem_.answer = [](ScriptedModem& modem, const std::string& body) {
    body.starts_with("CCCYC") ? modem.say("CADRQ,120000,1,0,0,2,1")
                              : ScriptedModem::usual(modem, body);
  };
  run(50);
  EXPECT_THAT(modem_.heardOf("CCTXD"), ElementsAre("CCTXD,1,0,0,"));
  EXPECT_EQ(talker_->counts().sent, 0U);
}

TEST_F(TalkerTest, TheModemIsAskedForEachFrameOnce) {
  modem_.answer = [](ScriptedModem& modem, const std::string& body) {
    if (body.starts_with("CCCYC")) {
      modem.say("CADRQ,120000,1,0,0,32,1");
      return;
    }
    if (!body.ends_with(",") && body.starts_with("CCTXD")) {
      modem.say("CADRQ,120000,1,0,0,32,2");
      modem.say("CADRQ,120000,1,0,0,32,3");
      return;
    }
    if (body.starts_with("CCCFG")) {
      ScriptedModem::usual(modem, body);
    }
  };
  run(44);
  EXPECT_THAT(modem_.heardOf("CCTXD"), ElementsAre("CCTXD,1,0,0,A51000", "CCTXD,1,0,0,"));
}

TEST_F(TalkerTest, WhatIsReceivedComesWithTheNextFrame) {
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

TEST_F(TalkerTest, WhatTheSenderDidNotKnowChangesNothing) {
  run(41);
  modem_.say("CARXD,2,0,0,1," + hexOf(talk_, 0, {12.5, 1}));
  run(5);
  modem_.say("CARXD,3,0,0,1," + hexOf(talk_, 0, {kNan, 0}));
  run(5);
  EXPECT_EQ(context_->readings[kPeerTop].value, 12.5);
  EXPECT_EQ(context_->readings[kPeerFound].value, 0);
}

TEST_F(TalkerTest, WhatHasNoRoomInAFrameWaits) {
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

TEST_F(TalkerTest, HeadingsAreStillConverted) {
  run(41);
  mission_.sensors.push_back(
      {"m_heading", nullptr, 1, 0, 6.3, 20, GLIDER_M_HEADING, kGliderMagnetic});
  GliderMission mission = mission_.mission;
  mission.sensors = mission_.sensors.data();
  mission.sensor_count = 4;
  const GliderCompass compass{-0.25, GLIDER_NO_SENSOR, 0, gliderHearAndConvertHeadings};
  mission.compass = &compass;
  context_->readings[kPeerTop].raw = 9;
  context_->readings[kPeerTop].waiting = 1;
  mission.sensor_count = 5;
  std::vector<GliderUpdate> frame(hooks::kMostSubscriptions, update(GLIDER_M_HEADING, 1));
  context_->variation = kNan;
  ASSERT_EQ(gliderHearAndConvertHeadings(&mission, context_, &variation_, frame.data(), 1), 2U);
  EXPECT_EQ(frame[0].value, 0.75);
  EXPECT_EQ(frame[1].value, 9);
}

TEST_F(TalkerTest, FramesThatAreNotOfTheFleetAreRefused) {
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
  for (const uint32_t place : {kPeerTop, kPeerFound}) {
    context->readings[place] = {};
  }
  return mission.memory;
}

TEST_F(TalkerTest, APeerThatLiesOnlyGivesValuesOfTheScales) {
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

TEST_F(TalkerTest, RubbishDoesNoHarm) {
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

TEST_F(TalkerTest, AModemThatNeverStopsIsReadInPieces) {
  modem_.bytes(std::string(100000, 'x'));
  poll();
  EXPECT_GE(modem_.unread(), 100000 - Talker::kMostBytesPerPoll);
  EXPECT_LT(modem_.unread(), 100000U);
}

TEST_F(TalkerTest, ASlowLineGetsWholeSentences) {
  modem_.takes = 5;
  run(120);
  EXPECT_THAT(modem_.heardOf("?"), IsEmpty());
  EXPECT_GE(modem_.heardOf("CCTXD").size(), 1U);
}

TEST_F(TalkerTest, ALineThatTakesNothingDoesNoHarm) {
  modem_.takes = 0;
  run(400);
  EXPECT_THAT(modem_.heard, IsEmpty());
  modem_.takes = 1000;
  run(100);
  EXPECT_GE(talker_->counts().sent, 1U);
}

TEST_F(TalkerTest, AClosedLineStaysClosed) {
  run(50);
  modem_.is_gone = true;
  run(1);
  EXPECT_TRUE(talker_->isClosed());
  modem_.is_gone = false;
  const size_t before = modem_.heard.size();
  run(200);
  EXPECT_EQ(modem_.heard.size(), before);
  make(1, 3);
  modem_.takes = kGliderStreamFailed;
  run(10);
  EXPECT_TRUE(talker_->isClosed());
}

TEST_F(TalkerTest, AnAddressThatNoVehicleHasDoesNothing) {
  for (const auto& [address, vehicles] : std::vector<std::pair<uint32_t, uint32_t>>{
           {0, 3}, {4, 3}, {16, 16}, {1, 16}, {1, 0}, {16, 15}}) {
    EXPECT_FALSE(Talker::isAddress(address, vehicles));
    make(address, vehicles);
    run(200);
  }
  EXPECT_THAT(modem_.heard, IsEmpty());
  EXPECT_TRUE(Talker::isAddress(15, 15));
  EXPECT_TRUE(Talker::isAddress(1, 1));
}

TEST_F(TalkerTest, EachVehicleHasASlotOfItsOwn) {
  std::vector<double> slots;
  for (uint32_t address = 1; address <= 3; ++address) {
    make(address, 3);
    const size_t before = timesOf("CCCYC").size();
    run(300);
    const auto times = timesOf("CCCYC");
    ASSERT_GT(times.size(), before);
    for (size_t i = before; i < times.size(); ++i) {
      EXPECT_EQ(std::fmod(std::floor(times[i] / kSlot), 3), address - 1.0);
    }
  }
}

}  // namespace
}  // namespace glider::runtime::testing
