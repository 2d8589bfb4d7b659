// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The dialogue with an acoustic modem, for any answer of it.

#include "tests/unit/runtime/talker_bench.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace glider::runtime::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

using TalkerDialogue = TalkerTest;

TEST_F(TalkerDialogue, SendsWhatTheMissionHasNow) {
  mission_.begin = [](GliderContext& c) { c.variables[kFound] = 1; };
  depth_ = 199.9;
  run(60);
  EXPECT_EQ(modem_.heardOf("CCTXD")[0].substr(12), hexOf(talk_, 0, {200, 1}));
  depth_ = 500;  // told as unknown, never as the end of the scale
  context_->variables[kFound] = 0;
  run(120);
  EXPECT_EQ(modem_.heardOf("CCTXD").back().substr(12), hexOf(talk_, 0, {kNan, 0}));
}

TEST_F(TalkerDialogue, AsksForItsAddressUntilTheModemHasIt) {
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

TEST_F(TalkerDialogue, BeforeTheMissionItSendsNothing) {
  flies_ = false;
  run(200);
  EXPECT_THAT(modem_.heard, ElementsAre("CCCFG,SRC,1"));
}

TEST_F(TalkerDialogue, AfterTheMissionItSendsNothing) {
  run(50);
  context_->finished = 1;
  run(12);
  const size_t before = modem_.heard.size();
  run(400);
  EXPECT_EQ(modem_.heard.size(), before);
}

TEST_F(TalkerDialogue, ACycleWithoutAnAnswerIsGivenUp) {
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

/// The frame would end in the slot of another vehicle.
TEST_F(TalkerDialogue, AModemThatAsksLateGetsNoData) {
  modem_.answer = [](ScriptedModem& modem, const std::string& body) {
    if (!body.starts_with("CCCYC")) {
      ScriptedModem::usual(modem, body);
    }
  };
  for (const double late_s : {1.0, 3.0}) {
    const size_t cycles = modem_.heardOf("CCCYC").size();
    while (modem_.heardOf("CCCYC").size() == cycles) {
      run(1);
    }
    run(late_s);
    modem_.say("CADRQ,120000,1,0,0,32,1");
    run(1);
    const std::string data = modem_.heard.back().substr(12);
    EXPECT_EQ(data.empty(), late_s > Talker::kLongestDialogueSecs) << late_s;
    run(2 * Talker::kPatienceSecs);
  }
}

/// A line that takes nothing for a while: what is written later begins no cycle of an old slot.
TEST_F(TalkerDialogue, ACycleThatWasGivenUpIsNotBegunLater) {
  run(20);
  modem_.takes = 0;
  const size_t before = modem_.heard.size();
  while (talker_->counts().unanswered == 0) {
    run(1);
  }
  modem_.takes = 1000;
  run(1);
  ASSERT_GT(modem_.heard.size(), before);
  EXPECT_EQ(modem_.heard[before], "CCCFG,SRC,1") << "not a cycle";
}

TEST_F(TalkerDialogue, AFrameWithoutAnEndIsGivenUp) {
  modem_.answer = [](ScriptedModem& modem, const std::string& body) {
    if (!body.starts_with("CCTXD")) {
      ScriptedModem::usual(modem, body);
    }
  };
  run(40 + Talker::kPatienceSecs + 2);
  EXPECT_EQ(talker_->counts().unanswered, 1U);
  EXPECT_EQ(talker_->counts().sent, 0U);
}

TEST_F(TalkerDialogue, ARefusalEndsTheCycleAtOnce) {
  modem_.answer = [](ScriptedModem& modem, const std::string& body) {
    body.starts_with("CCCYC") ? modem.say("CAERR,120000,NMEA,5")
                              : ScriptedModem::usual(modem, body);
  };
  modem_.say("CAERR,120000,NMEA,5");  // of nothing
  run(40);
  EXPECT_EQ(talker_->counts().unanswered, 1U);
}

TEST_F(TalkerDialogue, CyclesOfOthersAreNotItsOwn) {
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
TEST_F(TalkerDialogue, WithoutACycleOfItsOwnItGivesNoData) {
  run(50);
  const auto sent = talker_->counts().sent;
  modem_.say("CADRQ,120000,1,4,1,32,1");
  run(2);
  EXPECT_EQ(modem_.heard.back(), "CCTXD,1,4,1,");
  modem_.say("CATXF,0");
  run(2);
  EXPECT_EQ(talker_->counts().sent, sent);
}

TEST_F(TalkerDialogue, AFrameWithLessRoomGetsNoData) {
  modem_.answer = [](ScriptedModem& modem, const std::string& body) {
    body.starts_with("CCCYC") ? modem.say("CADRQ,120000,1,0,0,2,1")
                              : ScriptedModem::usual(modem, body);
  };
  run(50);
  EXPECT_THAT(modem_.heardOf("CCTXD"), ElementsAre("CCTXD,1,0,0,"));
  EXPECT_EQ(talker_->counts().sent, 0U);
}

TEST_F(TalkerDialogue, TheModemIsAskedForEachFrameOnce) {
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

TEST_F(TalkerDialogue, AModemThatNeverStopsIsReadInPieces) {
  modem_.bytes(std::string(100000, 'x'));
  poll();
  EXPECT_GE(modem_.unread(), 100000 - Talker::kMostBytesPerPoll);
  EXPECT_LT(modem_.unread(), 100000U);
}

TEST_F(TalkerDialogue, ASlowLineGetsWholeSentences) {
  modem_.takes = 5;
  run(120);
  EXPECT_THAT(modem_.heardOf("?"), IsEmpty());
  EXPECT_GE(modem_.heardOf("CCTXD").size(), 1U);
}

TEST_F(TalkerDialogue, ALineThatTakesNothingDoesNoHarm) {
  modem_.takes = 0;
  run(400);
  EXPECT_THAT(modem_.heard, IsEmpty());
  modem_.takes = 1000;
  run(100);
  EXPECT_GE(talker_->counts().sent, 1U);
}

TEST_F(TalkerDialogue, AClosedLineStaysClosed) {
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

TEST_F(TalkerDialogue, AnAddressThatNoVehicleHasDoesNothing) {
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

}  // namespace
}  // namespace glider::runtime::testing
