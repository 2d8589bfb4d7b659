// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// When a nap of the SBC begins and ends, what is sent and beaten meanwhile, and how it fails.

#include "tests/unit/hooks/nap_bench.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

namespace glider::hooks {
namespace {

using Kind = SeatEvent::Kind;

std::vector<Subscription> sensors() {
  return {{GLIDER_M_DEPTH}, {GLIDER_SCI_WATER_TEMP}, {GLIDER_M_LAT}};
}

/// Nothing but time ends it.
Nap plain(uint16_t length_s = 100, uint8_t wake_s = 0) {
  return {wake_s, length_s, 0, {}};
}

Nap until(NapKind kind, double value, uint16_t id = GLIDER_M_DEPTH) {
  Nap nap = plain(1000);
  nap.count = 1;
  nap.conditions[0] = {id, kind, value};
  return nap;
}

/// In control and awake, with only what `fixed` says.
class HookprogNaps : public testing::Test {
 protected:
  HookprogNaps() {
    bench.share = 0;
    bench.begin();
    bench.sent.clear();
    bench.events.clear();
  }

  bool sleeps(const Nap& nap) {
    bench.sleep(nap);
    return !bench.hookprog.wantsSbc();
  }

  /// The seconds until the SBC is woken, at most 2000.
  int secondsAsleep() {
    int seconds = 0;
    for (; seconds < 2000 && !bench.hookprog.wantsSbc(); ++seconds) {
      bench.second();
    }
    return seconds;
  }

  [[nodiscard]] NapEnd why() const { return static_cast<NapEnd>(bench.newest(Kind::SbcWoken).a); }

  template <typename Message>
  void say(const Message& message) {
    putMessage(bench.line.right(), message, ++said_);
  }

  NapBench bench{sensors()};
  uint8_t said_ = 100;
};

TEST_F(HookprogNaps, ANapBeginsWithItsDoneAndKeepsAllFrames) {
  ASSERT_TRUE(sleeps(until(NapKind::AtLeast, 1e9)));
  EXPECT_EQ(bench.newest(Kind::SbcNap).a, 1000U);
  EXPECT_EQ(bench.newest(Kind::SbcNap).b, 1U);
  bench.sent.clear();
  bench.seconds(200);
  EXPECT_TRUE(bench.sent.empty());
  EXPECT_FALSE(bench.hookprog.wantsSbc());
  EXPECT_EQ(bench.count(Kind::SbcNap), 1U);
}

TEST_F(HookprogNaps, ItEndsSoLongAfterTheTickThatWasAnswered) {
  ASSERT_TRUE(sleeps(plain(100)));
  const double answered_s = bench.ticks.back().vehicle_time_s;
  EXPECT_GT(secondsAsleep(), 90);
  EXPECT_EQ(why(), NapEnd::Length);
  EXPECT_EQ(bench.newest(Kind::SbcWoken).b, 25U);
  EXPECT_EQ(bench.ticks.back().vehicle_time_s, answered_s + 100);
}

TEST_F(HookprogNaps, OnlyTheDoneRightBehindItBeginsIt) {
  const auto done = [&](double time) {
    say(Done{bench.sent.back().sequence, 7, {time, 0, 0, MissionPhase::Flying}});
  };
  bench.sbc_answers = false;
  bench.seconds(5);  // a Tick has just been sent
  say(plain());
  bench.second();
  EXPECT_TRUE(bench.hookprog.wantsSbc()) << "its Done is not there";
  say(TransitionNotice{490, 1, 0, 1, 1, 0});
  done(500);
  bench.second();
  EXPECT_TRUE(bench.hookprog.wantsSbc()) << "something came between";
  bench.seconds(2);  // the next one
  say(plain());
  bench.second();
  done(510);
  bench.second();
  EXPECT_FALSE(bench.hookprog.wantsSbc());
}

TEST_F(HookprogNaps, TheOrderOfAnAnswerThatWasLostDoesNotWaitForTheNextDone) {
  bench.sbc_answers = false;
  bench.seconds(4);
  say(plain());
  bench.sent.clear();
  bench.seconds(4);
  ASSERT_EQ(bench.sent.size(), 1U) << "Ticks come as ever";
  say(Done{bench.sent[0].sequence, 7, {500, 0, 0, MissionPhase::Flying}});
  bench.second();
  EXPECT_TRUE(bench.hookprog.wantsSbc());
}

/// What is said with the number of a frame that is `back` Ticks older than the newest.
TEST_F(HookprogNaps, OnlyAnAnswerToTheNewestTickBeginsIt) {
  for (const uint32_t back : {1U, 0U}) {
    bench.sbc_answers = false;
    bench.sent.clear();
    bench.seconds(8);
    ASSERT_EQ(bench.sent.size(), 2U);
    say(plain());
    say(Done{bench.sent[1 - back].sequence, 7, {500.0 - back, 0, 0, MissionPhase::Flying}});
    bench.second();
    EXPECT_EQ(bench.hookprog.wantsSbc(), back == 1) << back;
    bench.seconds(3);
  }
}

TEST_F(HookprogNaps, BetweenTicksAnOrderHasNoEffect) {
  bench.seconds(2);
  ASSERT_FALSE(bench.sent.empty());  // and answered
  say(plain());
  say(Done{bench.sent.back().sequence, 7, {500, 0, 0, MissionPhase::Flying}});
  bench.second();
  EXPECT_TRUE(bench.hookprog.wantsSbc());
  EXPECT_EQ(bench.count(Kind::SbcNap), 0U);
}

TEST_F(HookprogNaps, ItIsTakenOnlyAsFarAsHookbehAllows) {
  for (const double most : {109.0, 0.0, std::nan("")}) {
    bench.nap_secs = most;
    bench.seconds(8);
    EXPECT_FALSE(sleeps(plain(100, 10))) << most;
  }
  EXPECT_EQ(bench.count(Kind::SbcNap), 0U);
  bench.nap_secs = 110;
  bench.seconds(8);
  EXPECT_TRUE(sleeps(plain(100, 10)));
}

TEST_F(HookprogNaps, OnlyTheSessionInControlTakesOne) {
  bench.session = 8;
  bench.seconds(8);
  EXPECT_FALSE(sleeps(plain()));
  bench.session = 0;
  bench.seconds(8);
  EXPECT_FALSE(sleeps(plain()));
  bench.session = 7;
  bench.state = HookState::Silent;
  bench.seconds(8);
  EXPECT_FALSE(sleeps(plain()));
  bench.state = HookState::Active;
  bench.seconds(8);
  EXPECT_TRUE(sleeps(plain()));
}

/// A program that answers without flying anything does not get its time by sleeping.
TEST_F(HookprogNaps, OnlyAHeartbeatBeginsIt) {
  bench.advances = false;
  bench.seconds(4);
  EXPECT_FALSE(sleeps(plain()));
}

TEST(HookprogNapFeature, IsOfferedIfAndOnlyIfTheVehicleHasTheSensor) {
  std::array<uint32_t, kGliderRoleCount> roles{};
  std::copy_n(gliderDictionary.roles, roles.size(), roles.begin());
  GliderDictionary dictionary = gliderDictionary;
  dictionary.roles = roles.data();
  for (const bool has : {true, false}) {
    roles[kGliderRoleHookNapSecs] = has ? uint32_t{GLIDER_X_HOOK_NAP_SECS} : GLIDER_NO_SENSOR;
    NapBench bench(sensors(), 1, dictionary);
    bench.begin();
    EXPECT_EQ(bench.client.mayNap(), has);
    bench.sleep(plain());
    EXPECT_EQ(bench.hookprog.wantsSbc(), !has);
    if (!has) {
      bench.sbc_answers = false;
      bench.seconds(4);
      putMessage(bench.line.right(), plain(), 200);
      bench.second();
      EXPECT_EQ(bench.count(Kind::BadFrame), 1U) << "it does not speak of naps";
    }
  }
}

TEST_F(HookprogNaps, AConditionThatHoldsInATickEndsIt) {
  struct Row {
    NapKind kind;
    double value, reported;
    bool ends;
  };
  const float third = 1.0F / 3;  // as a 4-byte sensor carries it: above 1/3
  for (const Row& row :
       {Row{NapKind::AtLeast, 20, 20, true}, Row{NapKind::AtLeast, 20, 19.5, false},
        Row{NapKind::AtMost, 20, 20, true}, Row{NapKind::AtMost, 20, 20.5, false},
        Row{NapKind::Known, 0, 5, true}, Row{NapKind::Known, 0, std::nan(""), false},
        Row{NapKind::AtLeast, third, 1.0 / 3, true}, Row{NapKind::AtMost, 1.0 / 3, 1.0 / 3, false},
        Row{NapKind::AtLeast, -1e9, std::nan(""), false}}) {
    ASSERT_TRUE(sleeps(until(row.kind, row.value)));
    bench.fixed[GLIDER_M_DEPTH] = row.reported;
    bench.seconds(6);
    EXPECT_EQ(bench.hookprog.wantsSbc(), row.ends) << row.value << " " << row.reported;
    EXPECT_TRUE(!row.ends || why() == NapEnd::Condition);
    bench.fixed.clear();
    bench.nap_secs = 0;  // ends it in any case
    bench.seconds(8);
    bench.nap_secs = 3600;
    bench.seconds(8);
  }
}

TEST_F(HookprogNaps, WhatTheSbcHoldsAlreadyEndsItOnlyIfAnyReportDoes) {
  bench.fixed[GLIDER_M_DEPTH] = 20;
  bench.seconds(8);
  ASSERT_TRUE(sleeps(until(NapKind::AtLeast, 10)));
  bench.seconds(16);
  EXPECT_FALSE(bench.hookprog.wantsSbc()) << "unchanged";
  bench.fixed[GLIDER_M_DEPTH] = 20.5;
  bench.seconds(6);
  EXPECT_TRUE(bench.hookprog.wantsSbc());
  bench.seconds(6);
  ASSERT_TRUE(sleeps(until(NapKind::Known, 0)));
  bench.seconds(6);
  EXPECT_TRUE(bench.hookprog.wantsSbc()) << "unchanged, but known";
}

TEST_F(HookprogNaps, AnythingThatHookbehSaysAnewEndsIt) {
  const auto ends = [&](auto&& change, auto&& back) {
    ASSERT_TRUE(sleeps(plain(1000)));
    bench.seconds(12);
    EXPECT_FALSE(bench.hookprog.wantsSbc());
    change();
    bench.seconds(6);
    EXPECT_TRUE(bench.hookprog.wantsSbc());
    EXPECT_EQ(why(), NapEnd::Vehicle);
    back();
    bench.seconds(12);
  };
  ends([&] { bench.state = HookState::Silent; }, [&] { bench.state = HookState::Active; });
  ends([&] { bench.session = 9; }, [&] { bench.session = 7; });
  ends([&] { bench.answered += 1; }, [&] { bench.answered -= 1; });
  ends([&] { bench.answer = 3; }, [&] { bench.answer = 1; });
}

TEST_F(HookprogNaps, AVehicleWhoseTimeGoesBackEndsIt) {
  ASSERT_TRUE(sleeps(plain(1000)));
  bench.seconds(12);
  bench.time_offset_s = -40;
  bench.seconds(6);
  EXPECT_TRUE(bench.hookprog.wantsSbc());
  EXPECT_EQ(why(), NapEnd::Length);
}

TEST_F(HookprogNaps, NapsThatAreNotAllowedAnyMoreEnd) {
  ASSERT_TRUE(sleeps(plain(1000)));
  bench.seconds(12);
  bench.nap_secs = 999;
  bench.seconds(6);
  EXPECT_TRUE(bench.hookprog.wantsSbc());
  EXPECT_EQ(why(), NapEnd::Forbidden);
}

TEST_F(HookprogNaps, AnyGoodFrameOfTheSbcEndsItAndABadOneDoesNot) {
  ASSERT_TRUE(sleeps(plain(1000)));
  bench.seconds(5);
  Frame noise;
  noise.type = MessageType::Done;  // too short
  put(bench.line.right(), noise);
  const uint8_t rubbish[] = {5, 1, 2, 3, 4, 0};
  bench.line.right().write(bench.line.right().self, rubbish, sizeof rubbish);
  bench.second();
  EXPECT_FALSE(bench.hookprog.wantsSbc());
  say(TransitionNotice{500, 1, 0, 1, 1, 0});
  bench.second();
  EXPECT_TRUE(bench.hookprog.wantsSbc());
  EXPECT_EQ(why(), NapEnd::Frame);
}

/// The science computer has a clock of its own, which may be set back.
TEST_F(HookprogNaps, WithoutCyclesItEndsByTheClockOfTheScienceComputer) {
  for (const bool set_back : {false, true}) {
    ASSERT_TRUE(sleeps(plain(100)));
    bench.cycles = false;
    bench.now -= set_back ? 10000 : 0;
    const int seconds = secondsAsleep();
    EXPECT_GE(seconds, 100);
    EXPECT_LE(seconds, 115);
    EXPECT_EQ(why(), NapEnd::Length);
    bench.cycles = true;
    bench.seconds(16);
  }
}

TEST_F(HookprogNaps, NothingIsSentBeforeTheSbcHadItsTimeToWake) {
  bench.wake_s = 22;
  ASSERT_TRUE(sleeps(plain(40, 22)));
  bench.sent.clear();
  secondsAsleep();
  EXPECT_TRUE(bench.sent.empty());
  int seconds = 0;
  for (; bench.sent.empty() && seconds < 100; ++seconds) {
    bench.second();
  }
  EXPECT_EQ(seconds, 22);
  EXPECT_EQ(bench.deaf, 0U);
  EXPECT_EQ(
      bench.ticks.back().cycle - bench.ticks[bench.ticks.size() - bench.sent.size()].cycle + 1,
      bench.sent.size())
      << "those that came meanwhile too";
}

TEST_F(HookprogNaps, AllButTheLastThatWereKeptSaySo) {
  ASSERT_TRUE(sleeps(plain(80)));
  const size_t before = bench.ticks.size();
  secondsAsleep();
  bench.seconds(12);
  ASSERT_GT(bench.ticks.size(), before + 20);
  for (size_t i = 0; i < bench.ticks.size(); ++i) {
    EXPECT_EQ(bench.ticks[i].kept, i >= before && i < before + 19) << i - before;
  }
}

TEST_F(HookprogNaps, HookprogBeatsForTheSbcOnceACycleUntilItAnswers) {
  bench.seconds(4);
  ASSERT_TRUE(sleeps(plain(40, 10)));
  std::vector<double> beats = bench.beats();
  double newest = beats.back();
  EXPECT_GT(newest, 0);
  secondsAsleep();
  beats = bench.beats();
  EXPECT_EQ(beats.size(), 10U);
  EXPECT_LE(-beats.front(), newest + 2);
  EXPECT_GT(-beats.front(), newest);
  newest = -beats.front() - 2;
  for (const double beat : beats) {
    EXPECT_EQ(beat, -(newest += 2));
  }
  bench.sbc_answers = false;  // it does not come
  bench.seconds(19);
  beats = bench.beats();
  EXPECT_GE(beats.size(), 4U);
  for (const double beat : beats) {
    EXPECT_EQ(beat, -(newest += 2));
  }
  bench.sbc_answers = true;
  bench.seconds(5);
  beats = bench.beats();
  ASSERT_FALSE(beats.empty());
  for (const double beat : beats) {
    newest += beat < 0 ? 2 : 1;
    EXPECT_EQ(beat, beat < 0 ? -newest : newest);
  }
}

/// So hookbeh knows two naps apart.
TEST_F(HookprogNaps, TheNumbersOfTwoNapsAreNeverAlikeEvenOrOdd) {
  bench.seconds(4);
  double before = -1;
  for (int nap = 0; nap < 5; ++nap) {
    ASSERT_TRUE(sleeps(plain(40, 4))) << nap;
    bench.seconds(8);
    const std::vector<double> beats = bench.beats();
    const double kind = std::fmod(-beats.back(), 2);
    EXPECT_LT(beats.back(), 0);
    EXPECT_NE(kind, before) << nap;
    before = kind;
    bench.seconds(60 + nap * 4);
    (void)bench.beats();
  }
}

TEST_F(HookprogNaps, ForASessionThatIsNotInControlItDoesNotBeat) {
  ASSERT_TRUE(sleeps(plain(1000)));
  bench.seconds(8);
  bench.sbc_answers = false;
  bench.session = 9;
  bench.seconds(5);
  (void)bench.beats();
  bench.seconds(8);
  EXPECT_TRUE(bench.beats().empty());
}

TEST_F(HookprogNaps, AnSbcThatDoesNotComeBackIsLostAndItsTicksWithIt) {
  ASSERT_TRUE(sleeps(plain(100)));
  bench.sbc_answers = false;
  secondsAsleep();
  EXPECT_EQ(bench.count(Kind::SbcLost), 0U);
  bench.seconds(11);
  EXPECT_EQ(bench.count(Kind::SbcLost), 0U);
  bench.second();
  EXPECT_EQ(bench.count(Kind::SbcLost), 1U) << "12 s after the first of them";
  (void)bench.beats();
  bench.sent.clear();
  bench.seconds(8);
  EXPECT_EQ(typesOf(bench.sent), (std::vector{MessageType::Beacon, MessageType::Beacon}));
  EXPECT_TRUE(bench.beats().empty());
  bench.sbc_answers = true;
  bench.ticks.clear();
  bench.seconds(12);
  ASSERT_FALSE(bench.ticks.empty());
  EXPECT_FALSE(bench.ticks[0].kept) << "nothing is left of the nap";
}

TEST_F(HookprogNaps, AClosedLineEndsItWithAllThatWasKept) {
  ASSERT_TRUE(sleeps(plain(1000)));
  bench.seconds(40);
  bench.line.close();
  bench.second();
  EXPECT_EQ(bench.count(Kind::SbcLost), 1U);
  EXPECT_TRUE(bench.hookprog.wantsSbc());
  (void)bench.beats();
  bench.seconds(8);
  EXPECT_TRUE(bench.beats().empty());
}

TEST_F(HookprogNaps, ANewLinkForgetsWhatWasKept) {
  ASSERT_TRUE(sleeps(plain(1000)));
  bench.seconds(40);
  Hello hello;
  hello.dictionary = gliderDictionary.hash;
  hello.link = 99;
  bench.sbc_answers = false;
  bench.sent.clear();
  say(hello);
  bench.second();
  EXPECT_TRUE(bench.hookprog.wantsSbc());
  EXPECT_EQ(typesOf(bench.sent), std::vector{MessageType::Welcome});
  bench.seconds(4);
  ASSERT_EQ(bench.sent.size(), 2U);
  TickHead head;
  ASSERT_TRUE(decode(bench.sent[1], head));
  EXPECT_EQ(head.link, 99U);
}

TEST_F(HookprogNaps, ANapIsNoLackOfProgressButAStuckMissionBehindItIs) {
  ASSERT_TRUE(sleeps(plain(200, 20)));
  bench.wake_s = 20;
  bench.advances = false;
  secondsAsleep();
  bench.seconds(22);
  EXPECT_EQ(bench.count(Kind::SbcStuck), 0U);
  bench.seconds(16);
  EXPECT_EQ(bench.count(Kind::SbcStuck), 1U);
}

TEST_F(HookprogNaps, AfterOneThereMayBeAnother) {
  for (int i = 0; i < 20; ++i) {
    ASSERT_TRUE(sleeps(plain(40))) << i;
    secondsAsleep();
    bench.seconds(1);
  }
  EXPECT_EQ(bench.count(Kind::SbcNap), 20U);
  EXPECT_EQ(bench.count(Kind::SbcLost), 0U);
}

}  // namespace
}  // namespace glider::hooks
