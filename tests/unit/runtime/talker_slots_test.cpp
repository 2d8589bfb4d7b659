// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// When a vehicle sends: in the slot of its address, by UTC.

#include "tests/unit/runtime/talker_bench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>

namespace glider::runtime::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

using TalkerSlots = TalkerTest;

TEST_F(TalkerSlots, SendsInItsSlot) {
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

/// A slot of this vehicle comes every 36 s, so a message of every minute is sent every 72 s.
TEST_F(TalkerSlots, KeepsThePeriods) {
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

TEST_F(TalkerSlots, TheMostOverdueComesFirst) {
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

TEST_F(TalkerSlots, WithoutUtcItSendsNothing) {
  reports_utc_ = false;
  run(300);
  EXPECT_THAT(modem_.heard, ElementsAre("CCCFG,SRC,1"));
  reports_utc_ = true;
  run(100);
  EXPECT_FALSE(modem_.heardOf("CCCYC").empty());
}

/// The mission's reading is older than its `stale_after`, 20 s, before this clock gives up.
TEST_F(TalkerSlots, WhatTheMissionDoesNotKnowItDoesNotKnow) {
  make(1, 1);
  talk_.messages[0].period = 1;
  run(100);
  reports_utc_ = false;
  run(24);
  const size_t before = modem_.heardOf("CCCYC").size();
  run(60);
  EXPECT_EQ(modem_.heardOf("CCCYC").size(), before);
}

TEST_F(TalkerSlots, WhenTheVehicleFallsSilentUtcIsSoonUnknown) {
  run(100);
  flies_ = false;
  run(talk::SlotClock::kMostWithoutReport + 1);
  const size_t before = modem_.heard.size();
  run(400);
  EXPECT_EQ(modem_.heard.size(), before);
}

/// By the tick alone a slot could be missed: a slot of 3 s begins and ends between two frames.
TEST_F(TalkerSlots, BetweenFramesUtcGoesOnByTheClock) {
  talk_.slot_s = 3;
  talk_.messages[0].period = 9;
  run(300);
  const auto times = timesOf("CCCYC");
  EXPECT_GE(times.size(), 20U);
  for (const double time : times) {
    EXPECT_EQ(std::fmod(std::floor(time / 3), 3), 0) << time;
  }
}

TEST_F(TalkerSlots, AfterAJumpOfUtcTheSlotsAreThoseOfTheNewTime) {
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

/// The report that is least late counts, of the last eight: not the newest.
TEST_F(TalkerSlots, ReportsThatAreLateNowMoreAndNowLessBeginNoSlotLate) {
  make(1, 1);
  talk_.messages[0].period = 1;
  for (int i = 0; i < 150; ++i) {
    report_is_late_ = i % 3 == 0 ? 0 : 3;
    run(kCycle);
  }
  const auto times = timesOf("CCCYC");
  EXPECT_GE(times.size(), 40U);
  for (const double time : times) {
    if (time > kMidnight + 8 * kCycle) {  // eight reports
      EXPECT_LE(std::fmod(time, kSlot), 1) << time;
    }
  }
}

/// A cycle that takes 15 s: its report of UTC is late by that.
TEST_F(TalkerSlots, AReportThatIsLateMovesNoSlot) {
  run(120);
  utc_is_ahead_ -= 15;
  run(kCycle);
  utc_is_ahead_ += 15;
  run(400);
  for (const double time : timesOf("CCCYC")) {
    EXPECT_EQ(std::fmod(std::floor(time / kSlot), 3), 0) << time;
  }
}

TEST_F(TalkerSlots, AClockThatJumpsDoesNoHarm) {
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
TEST_F(TalkerSlots, UtcOfACheckpointIsNotTrusted) {
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

TEST_F(TalkerSlots, ASlotThatHasBegunLongAgoIsNotUsed) {
  modem_.answer = [](ScriptedModem&, const std::string&) {};
  run(36 + 4);
  modem_.say("CACFG,SRC,1");  // 5 s of its slot have passed when it reads this
  run(36 - 5);
  EXPECT_THAT(modem_.heardOf("CCCYC"), IsEmpty());
  run(5);
  EXPECT_THAT(modem_.heardOf("CCCYC"), SizeIs(1));
}

TEST_F(TalkerSlots, ASlotThatHasJustBegunIsUsed) {
  modem_.answer = [](ScriptedModem&, const std::string&) {};
  run(36 + 3);
  modem_.say("CACFG,SRC,1");
  run(1);
  EXPECT_THAT(modem_.heardOf("CCCYC"), SizeIs(1));
}

TEST_F(TalkerSlots, EachVehicleHasASlotOfItsOwn) {
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
