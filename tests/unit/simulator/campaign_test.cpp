// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What a campaign draws, promises and sees.

#include "hooks/protocol/messages.h"
#include "platforms/slocum_sensors.h"
#include "simulator/campaign/draw_faults.h"
#include "simulator/campaign/flight_judge.h"
#include "tests/unit/simulator/fake_sbc.h"
#include "tests/unit/simulator/flights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

namespace glider::simulator {
namespace {

using hooks::HookState;
using Outcome = Verdict::Outcome;

constexpr double kSilence = 24, kCycle = 4;

constexpr FlightTimes kTimes = {1000, 30, 900, 30};

/// Something of what was drawn, as a number: two draws that are alike have the same.
double signature(const DrawnFaults& drawn) {
  double sum = drawn.water_depth_m.value_or(0) + (drawn.args ? drawn.args->max_depth_m : 0);
  sum += drawn.faults.empty() ? 0 : drawn.faults.first();
  for (const Leftover& leftover : drawn.faults.leftover) {
    sum += leftover.depth_m;
  }
  return sum;
}

TEST(DrawFaults, EveryKindDrawsSomethingWithinTheFlightAndTheSameForASeed) {
  for (uint32_t k = 1; k < kFaultKinds; ++k) {
    for (uint32_t m = 0; m < kManners; ++m) {
      const auto kind = static_cast<FaultKind>(k);
      const auto manner = static_cast<Manner>(m);
      SCOPED_TRACE(std::string(nameOf(kind)) + " " + nameOf(manner));
      for (uint64_t seed = 0; seed < 20; ++seed) {
        const DrawnFaults drawn = drawFaults(kind, manner, seed, kTimes);
        EXPECT_TRUE(!drawn.faults.empty() || drawn.args || drawn.water_depth_m);
        EXPECT_TRUE(drawn.faults.empty() || drawn.faults.first() < 1100);
        EXPECT_EQ(signature(drawn), signature(drawFaults(kind, manner, seed, kTimes)));
        EXPECT_NE(signature(drawn), signature(drawFaults(kind, manner, seed + 100, kTimes)));
      }
    }
  }
  EXPECT_TRUE(drawFaults(FaultKind::None, Manner::Together, 1, kTimes).faults.empty());
}

TEST(DrawFaults, MannersSayWhen) {
  for (uint64_t seed = 0; seed < 30; ++seed) {
    const auto draw = [&](Manner manner) {
      return drawFaults(FaultKind::LineCut, manner, seed, kTimes);
    };
    EXPECT_LE(draw(Manner::Handshake).faults.first(), kTimes.take_s + 30);
    EXPECT_GE(draw(Manner::Exit).faults.first(), kTimes.give_back_s - 40);
    EXPECT_GE(draw(Manner::Recurring).faults.lines.size(), 2 * 3U);
    for (const LineFault& fault : draw(Manner::ForGood).faults.lines) {
      EXPECT_EQ(fault.when.to_s, kForever);
    }
    EXPECT_EQ(draw(Manner::Once).kinds.size(), 1U);
    EXPECT_GE(draw(Manner::Together).kinds.size(), 2U);
  }
}

TEST(DrawFaults, WhatIsDrawnForTheWorldGetsIntoIt) {
  Scenario scenario = shippedSetup("default").scenario;
  const DrawnFaults tight = drawFaults(FaultKind::TightLimits, Manner::Once, 1, kTimes);
  tight.applyTo(scenario);
  drawFaults(FaultKind::ShallowWater, Manner::Once, 1, kTimes).applyTo(scenario);
  const platforms::Platform platform = shippedSetup("default").platform;
  const JudgeSetup judged = judgeSetup(platform, scenario, {FaultKind::TightLimits});
  EXPECT_EQ(judged.args.greatest_depth_m, tight.args->max_depth_m);
  EXPECT_EQ(judged.args.start_secs, tight.args->start_secs);
  EXPECT_EQ(judged.overdepth_m, 70);
  EXPECT_LE(scenario.ocean.bottom.depth_m, 36);
}

TEST(Promises, AreThoseOfTheDocumentWordForWord) {
  std::ifstream file(std::string(GLIDER_SOURCE_DIR) + "/scenarios/README.md");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::string head =
      "| fault | the SBC's control | true depth at most | clearance | follows |\n"
      "|---|---|---|---|---|\n";
  const size_t at = text.find(head);
  ASSERT_NE(at, std::string::npos);
  const size_t begin = at + head.size();
  EXPECT_EQ(text.substr(begin, text.find("\n\n", begin) + 1 - begin),
            promiseTable(kSilence, kCycle));
}

TEST(Promises, OfFaultsThatComeTogetherAreTheWeaker) {
  const FaultKind sensors[] = {FaultKind::SensorFrozen, FaultKind::SensorNan};
  EXPECT_EQ(promiseOf(sensors).deepest, Deepest::OneAndAHalf);
  const FaultKind mixed[] = {FaultKind::Clock, FaultKind::SensorFrozen};
  EXPECT_EQ(promiseOf(mixed).deepest, Deepest::TenMetres);
  EXPECT_EQ(promiseOf(mixed).control, Control::Any);
  EXPECT_FALSE(promiseOf(mixed).clearance);
  const FaultKind lines[] = {FaultKind::LineCut, FaultKind::Clock};
  EXPECT_EQ(promiseOf(lines).control, Control::Silent);
  EXPECT_EQ(deepestAllowed(Deepest::Overshoot, 60), 65);
  EXPECT_EQ(deepestAllowed(Deepest::TenMetres, 60), 70);
  EXPECT_EQ(deepestAllowed(Deepest::OneAndAHalf, 60), 90);
}

TEST(StatedTimes, AreThoseOfTheWatchdogs) {
  Faults faults;
  faults.power = {{100, 200}};
  faults.lines = {{.when = {300, kForever}, .cut = true}, {.when = {0, 50}, .delay_s = 2}};
  faults.aborts = {500};
  const StatedTimes stated = statedTimes(faults, kSilence, kCycle);
  ASSERT_EQ(stated.hand_backs.size(), 3U);
  EXPECT_EQ(stated.hand_backs[0].when.from_s, 100 + 32 + 2);
  EXPECT_EQ(stated.hand_backs[0].when.to_s, 200);
  EXPECT_EQ(stated.hand_backs[1].when.from_s, 300 + 32 + 2);
  EXPECT_EQ(stated.hand_backs[2].when.from_s, 500);
  EXPECT_EQ(stated.most_standstill_s, 56 + 2);
}

/// A judge that is told a story: what the SBC says, what hookbeh does with it.
class Judged : public testing::Test {
 protected:
  Judged() : array_(shippedSetup("default").platform) {}

  void say(hooks::Frame& frame) {
    frame.sequence = ++frame_sequence_;
    std::array<uint8_t, hooks::kMostEncodedBytes> bytes;
    judge_.said({bytes.data(), hooks::encodeFrame(frame, bytes.data())}, now_);
  }
  void instruct(uint32_t session, uint16_t sequence, hooks::HookControl control,
                double depth = 20) {
    hooks::Frame frame;
    hooks::encodeEmptyList(hooks::MessageType::Write, frame);
    const std::pair<uint16_t, double> words[] = {
        {GLIDER_SCI_HOOK_SESSION, session},
        {GLIDER_SCI_HOOK_CONTROL, static_cast<double>(control)},
        {GLIDER_SCI_HOOK_VERTICAL, 1},
        {GLIDER_SCI_HOOK_DEPTH, depth},
        {GLIDER_SCI_HOOK_PITCH, kPitch},
        {GLIDER_SCI_HOOK_LATERAL, 0},
        {GLIDER_SCI_HOOK_HEADING, 0},
        {GLIDER_SCI_HOOK_LAT, 0},
        {GLIDER_SCI_HOOK_LON, 0},
        {GLIDER_SCI_HOOK_CHECK, 7},
        {GLIDER_SCI_HOOK_SEQUENCE, sequence}};
    for (const auto& [id, value] : words) {
      ASSERT_TRUE(hooks::appendValue(frame, {id, value}));
      arriving_.emplace_back(id, value);
    }
    say(frame);
  }
  /// What was instructed gets into the sensor array.
  void arrive() {
    for (const auto& [id, value] : arriving_) {
      array_.set(id, value);
    }
    arriving_.clear();
  }
  void done(uint32_t session) {
    hooks::Frame frame;
    hooks::Done done;
    done.session = session;
    done.status.mission_time_s = now_;
    hooks::encode(done, frame);
    say(frame);
  }
  void obey(uint16_t sequence, uint32_t session = 1) {
    array_.set(GLIDER_X_HOOK_SESSION, session);
    array_.set(GLIDER_X_HOOK_SEQUENCE, sequence);
    array_.set(GLIDER_X_HOOK_ANSWER, static_cast<double>(hooks::HookAnswer::Accepted));
  }
  bool cycle(HookState hook, double depth = 0.1, bool aborted = false) {
    now_ += kCycle;
    out_.commanding = hook == HookState::Active;
    array_.set(GLIDER_M_DEPTH, std::isnan(reading_) ? depth : reading_);
    return judge_.cycle({now_, hook, depth, aborted, false, array_, now_ - restarted_s_, clearance_,
                         used_J_, 14, whole_, aborted ? nullptr : &out_});
  }
  /// Up to `until_s` in control, the mission going on.
  void fly(double until_s) {
    while (now_ < until_s) {
      done(1);
      cycle(HookState::Active, 10);
    }
  }
  void take() {
    instruct(1, 1, hooks::HookControl::Take);
    arrive();
    obey(1);
    fly(40);
  }
  void giveBack() {
    instruct(1, 9, hooks::HookControl::GiveBack);
    arrive();
    obey(9);
    cycle(HookState::Complete);
  }
  [[nodiscard]] std::string violation() const { return judge_.verdict().violation; }

  static JudgeSetup setup() {
    JudgeSetup setup;
    setup.faults.power = {{200, 400}};
    setup.promise = promiseOf(FaultKind::Power);
    setup.has_hookbeh = true;
    setup.args.greatest_depth_m = 60;
    setup.overdepth_m = 70;
    setup.undervolts = 10;
    setup.hull_m = 200;
    setup.mean_W = 3;
    return setup;
  }
  FlightJudge judge_{setup()};
  hooks::HookbehOutputs out_ = dives();
  static hooks::HookbehOutputs dives() {
    hooks::HookbehOutputs out;
    out.commanding = true;
    out.pitch_rad = kPitch;
    out.pump_cc = -230;
    return out;
  }
  void climb() {
    out_.pitch_rad = 0.4538;
    out_.pump_cc = 230;
  }
  double restarted_s_ = 0, clearance_ = 100, used_J_ = 0;
  double reading_ = std::nan("");  ///< of m_depth; NaN: the truth
  bool whole_ = true;
  static constexpr double kPitch = -0.5;
  SensorArray array_;
  double now_ = 0;
  uint8_t frame_sequence_ = 0;
  std::vector<std::pair<uint16_t, double>> arriving_;
};

TEST_F(Judged, AGoodFlightExits) {
  take();
  instruct(1, 2, hooks::HookControl::Steer, 5);
  cycle(HookState::Active);
  arrive();
  obey(2);
  fly(80);
  giveBack();
  EXPECT_EQ(judge_.verdict().outcome, Outcome::Exited) << violation();
  EXPECT_EQ(judge_.verdict().instructions, 3U);
  EXPECT_EQ(judge_.verdict().hand_backs, 0U);
}

TEST_F(Judged, AFlightWithoutTheSbcAtTheEndIsHandedBack) {
  take();
  cycle(HookState::Silent);
  EXPECT_EQ(judge_.verdict().outcome, Outcome::HandedBack) << violation();
  EXPECT_EQ(judge_.verdict().hand_backs, 1U);
}

TEST_F(Judged, WhatWasNotSaidSoIsSeen) {
  take();
  instruct(1, 2, hooks::HookControl::Steer, 5);
  arrive();
  array_.set(GLIDER_SCI_HOOK_DEPTH, 6);
  obey(2);
  cycle(HookState::Active);
  EXPECT_EQ(violation(), "instruction 2 of session 1 is obeyed, but was not said so");
}

TEST_F(Judged, AnInstructionObeyedTwiceIsSeen) {
  take();
  instruct(1, 2, hooks::HookControl::Steer, 5);
  arrive();
  obey(2);
  cycle(HookState::Active);
  instruct(1, 1, hooks::HookControl::Take);
  arrive();
  obey(1);
  cycle(HookState::Active);
  EXPECT_EQ(violation(), "instruction 1 of session 1 is obeyed twice");
}

TEST_F(Judged, ANumberThatIsUsedForOtherWordsIsSeen) {
  take();
  instruct(1, 1, hooks::HookControl::Take, 12);
  EXPECT_EQ(violation(), "instruction 1 of session 1 is said anew with other words");
}

TEST_F(Judged, ALostInstructionIsSeen) {
  take();
  instruct(1, 2, hooks::HookControl::Steer, 5);
  fly(now_ + 56);
  cycle(HookState::Silent);
  EXPECT_EQ(violation(), "") << "let go in time";
  fly(now_ + 64);
  EXPECT_EQ(violation(), "instruction 2 of session 1 is lost: no answer for 60 s");
}

TEST_F(Judged, AMissionThatStandsStillInControlIsSeen) {
  take();
  for (int i = 0; i < 13; ++i) {
    cycle(HookState::Active);
  }
  EXPECT_EQ(violation().find("stood still"), std::string::npos);
  cycle(HookState::Active);
  EXPECT_NE(violation().find("stood still for 60 s"), std::string::npos) << violation();
}

TEST_F(Judged, ControlBeyondTheStatedTimeIsSeen) {
  take();
  fly(232);
  EXPECT_EQ(violation().find("no power"), std::string::npos);
  fly(236);
  EXPECT_EQ(violation(), "the SBC is in control though the SBC has no power");
  EXPECT_EQ(judge_.verdict().violation_s, 236);
}

TEST_F(Judged, ControlWithoutAHandshakeIsSeen) {
  instruct(1, 1, hooks::HookControl::Steer);
  arrive();
  obey(1);
  cycle(HookState::Active);
  EXPECT_EQ(violation(), "control is taken without a handshake");
}

TEST_F(Judged, AnotherSessionWithoutAHandshakeIsSeen) {
  take();
  instruct(2, 2, hooks::HookControl::Steer);
  arrive();
  obey(2, 2);
  cycle(HookState::Active);
  EXPECT_EQ(violation(), "control is taken without a handshake");
}

TEST_F(Judged, AnInstructionAfterControlWasGivenBackIsSeen) {
  take();
  giveBack();
  instruct(2, 10, hooks::HookControl::Take);
  arrive();
  obey(10, 2);
  cycle(HookState::Active);
  EXPECT_EQ(violation(), "instruction 10 of session 2 is obeyed after control was given back");
}

TEST_F(Judged, WhatArrivesWhenHookbehDoesNotListenIsNotObeyed) {
  take();
  instruct(2, 2, hooks::HookControl::Take);
  arrive();  // x_hook_sequence stays at 1, accepted
  cycle(HookState::Silent);
  cycle(HookState::Complete, 0.1, true);
  EXPECT_EQ(violation(), "");
  EXPECT_EQ(judge_.verdict().instructions, 1U);
}

TEST_F(Judged, AFlightThatDoesNotEndIsSeen) {
  take();
  EXPECT_EQ(violation(), "the flight does not end in time");
  cycle(HookState::Silent, 10);
  EXPECT_EQ(violation(), "not at the surface in time");
}

// What the judge must see of the vehicle: each test plants one fault in a good flight's trace.

TEST_F(Judged, TrueDepthPastMaxDepthIsSeenWhateverTheSensorSays) {
  take();
  reading_ = 20;
  out_.pitch_rad = 0.4;
  out_.pump_cc = 230;
  cycle(HookState::Active, 64.9);
  EXPECT_EQ(violation().find("deep under"), std::string::npos) << violation();
  cycle(HookState::Active, 65.1);
  EXPECT_EQ(violation(), "65.1 m deep under max_depth 60 m");
}

TEST_F(Judged, WithoutTheSbcTheDepthIsHeldAgainstOverdepth) {
  take();
  cycle(HookState::Silent, 74);
  EXPECT_EQ(violation().find("deep under"), std::string::npos) << violation();
  cycle(HookState::Silent, 76);
  EXPECT_EQ(violation(), "76.0 m deep under overdepth 70 m");
}

TEST_F(Judged, ADepthFromBeforeTheLimitIsNoViolationUntilItIsLeft) {
  cycle(HookState::Ready, 72);
  instruct(1, 1, hooks::HookControl::Take);
  arrive();
  obey(1);
  climb();
  cycle(HookState::Active, 73);
  EXPECT_EQ(violation().find("deep under"), std::string::npos) << violation();
  cycle(HookState::Active, 50);
  cycle(HookState::Active, 66);
  EXPECT_NE(violation().find("66.0 m deep under max_depth 60"), std::string::npos) << violation();
}

TEST_F(Judged, TheHullsLimitHoldsAlways) {
  cycle(HookState::Ready, 201);
  EXPECT_EQ(violation(), "201.0 m deep, and the hull is made for 200 m");
}

TEST_F(Judged, TooLittleClearanceIsSeen) {
  take();
  clearance_ = 1.1;
  climb();
  cycle(HookState::Active, 30);
  EXPECT_EQ(violation().find("over the bottom"), std::string::npos) << violation();
  clearance_ = 0.9;
  cycle(HookState::Active, 30);
  EXPECT_EQ(violation(), "0.9 m over the bottom under min_altitude 5 m");
}

TEST_F(Judged, TheBottomIsSeenAlsoWithoutTheSbc) {
  clearance_ = 0;
  cycle(HookState::Silent, 30);
  EXPECT_EQ(violation(), "the vehicle is on the bottom");
}

TEST_F(Judged, ACycleWithoutACommandIsSeen) {
  take();
  out_.commanding = false;
  now_ += kCycle;
  judge_.cycle({now_, HookState::Active, 10, false, false, array_, now_, 100, 0, 14, true, &out_});
  EXPECT_EQ(violation(), "heading, pitch and pump are not all commanded");
}

TEST_F(Judged, AnIdleStackIsSeen) {
  take();
  whole_ = false;
  cycle(HookState::Active, 10);
  EXPECT_EQ(violation(), "heading, pitch and pump are not all commanded");
}

TEST_F(Judged, ACommandThatIsNoNumberIsSeen) {
  take();
  out_.heading_rad = std::nan("");
  cycle(HookState::Active, 10);
  EXPECT_EQ(violation(), "heading, pitch and pump are not all commanded");
}

TEST_F(Judged, CommandsBeyondTheArgsAreSeen) {
  take();
  out_.pitch_rad = -0.7;
  cycle(HookState::Active, 10);
  EXPECT_EQ(violation(), "a pitch of -0.70 rad is commanded under max_pitch 0.61");
}

TEST_F(Judged, APumpBeyondTheArgsIsSeen) {
  take();
  out_.pump_cc = -240;
  cycle(HookState::Active, 10);
  EXPECT_EQ(violation(), "a pump of -240 cc is commanded");
}

TEST_F(Judged, CommandsWithoutControlAreSeen) {
  now_ += kCycle;
  judge_.cycle({now_, HookState::Silent, 10, false, false, array_, now_, 100, 0, 14, true, &out_});
  EXPECT_EQ(violation(), "hookbeh commands, and the SBC is not in control");
}

TEST_F(Judged, AGuardThatDoesNotClimbIsSeen) {
  take();
  reading_ = 61;
  cycle(HookState::Active, 20);
  cycle(HookState::Active, 20);
  EXPECT_EQ(violation(), "m_depth says 61.0 m, and hookbeh does not climb");
}

TEST_F(Judged, AnUnknownDepthWithoutAClimbIsSeen) {
  take();
  for (int i = 0; i < 2; ++i) {
    now_ += kCycle;
    array_.set(GLIDER_M_DEPTH, std::nan(""));
    judge_.cycle(
        {now_, HookState::Active, 10, false, false, array_, now_, 100, 0, 14, true, &out_});
  }
  EXPECT_EQ(violation(), "the depth is unknown, and hookbeh does not climb");
}

TEST_F(Judged, AGuardThatDoesNotMindTheBottomIsSeen) {
  take();
  clearance_ = 3.5;
  for (int i = 0; i < 4; ++i) {
    cycle(HookState::Active, 10);
  }
  EXPECT_EQ(violation(), "3.5 m over the bottom, and hookbeh does not climb");
}

TEST_F(Judged, AGuardWithoutALimitIsSeen) {
  take();
  climb();
  out_.guarding = true;
  out_.doing = "climb: too deep";
  cycle(HookState::Active, 10);
  EXPECT_EQ(violation(), "the guard comes in (climb: too deep) and no limit is near");
}

TEST_F(Judged, AnInstructionThatIsNotCarriedOutIsSeen) {
  take();
  out_.pitch_rad = -0.4;
  cycle(HookState::Active, 10);
  EXPECT_EQ(violation(), "no dive to 20 m though it is in force");
}

TEST_F(Judged, ADiveThatGoesOnPastItsTargetIsSeen) {
  take();
  cycle(HookState::Active, 20.9);
  EXPECT_EQ(violation().find("diving"), std::string::npos) << violation();
  cycle(HookState::Active, 21.1);
  EXPECT_EQ(violation(), "still diving 1.1 m past 20 m");
}

TEST_F(Judged, HoveringFarFromItsDepthIsSeen) {
  take();
  cycle(HookState::Active, 20);
  out_.pitch_rad = 0;
  for (int i = 0; i < 16; ++i) {
    done(1);
    cycle(HookState::Active, 26.5);
  }
  EXPECT_EQ(violation(), "hovers 6.5 m from its depth");
}

TEST_F(Judged, AnInstructionOutsideTheArgsThatIsObeyedIsSeen) {
  take();
  instruct(1, 2, hooks::HookControl::Steer, 61);
  arrive();
  obey(2);
  cycle(HookState::Active);
  EXPECT_EQ(violation(), "instruction 2 is obeyed though it is outside the b_args");
}

TEST_F(Judged, ARefusalWithoutAReasonIsSeen) {
  take();
  instruct(1, 2, hooks::HookControl::Steer, 50);
  arrive();
  obey(2);
  array_.set(GLIDER_X_HOOK_ANSWER, static_cast<double>(hooks::HookAnswer::TooDeep));
  cycle(HookState::Active, 10);
  EXPECT_EQ(violation(), "instruction 2 is refused for a reason that is none");
}

TEST_F(Judged, ALostSessionThatTakesControlAgainIsSeen) {
  take();
  cycle(HookState::Silent);
  instruct(1, 2, hooks::HookControl::Take);
  arrive();
  obey(2);
  cycle(HookState::Active, 10);
  EXPECT_EQ(violation(), "session 1 takes control though session 1 has lost it");
}

TEST_F(Judged, AfterARestartOfTheFlightControllerAnOldInstructionIsObeyedTwice) {
  take();
  restarted_s_ = now_;
  cycle(HookState::Active, 10);  // session 1 again, without a word of the SBC
  EXPECT_NE(violation(), "");
}

TEST_F(Judged, WhatGarbledInstructionsAnswerIsNoAnswer) {
  take();
  instruct(1, 2, hooks::HookControl::Steer, 5);
  array_.set(GLIDER_X_HOOK_SEQUENCE, 2);
  array_.set(GLIDER_X_HOOK_ANSWER, static_cast<double>(hooks::HookAnswer::BadCheck));
  fly(now_ + 64);
  EXPECT_EQ(violation(), "instruction 2 of session 1 is lost: no answer for 60 s");
}

TEST_F(Judged, AVehicleThatDoesNotComeUpIsSeen) {
  take();
  while (now_ < 40 + 120 + 10 / 0.05) {
    cycle(HookState::Silent, 10);
  }
  EXPECT_EQ(violation().find("still"), std::string::npos) << violation();
  cycle(HookState::Silent, 10);
  cycle(HookState::Silent, 10);
  EXPECT_EQ(violation(), "still 10.0 m deep though nothing dives any more");
}

TEST_F(Judged, APumpThatDrainsTheBatteriesIsSeen) {
  take();
  used_J_ = 8000 + 2 * 3 * (now_ + kCycle) + 1;
  cycle(HookState::Silent);
  EXPECT_NE(violation().find("the batteries have given"), std::string::npos) << violation();
}

TEST(JudgeKept, ControlThatIsLostWithoutAReasonIsSeen) {
  JudgeSetup setup;
  setup.promise = promiseOf(FaultKind::Clock);
  setup.has_hookbeh = true;
  FlightJudge judge(setup);
  const SensorArray array(shippedSetup("default").platform);
  hooks::HookbehOutputs out;
  const auto cycle = [&](double now, HookState hook) {
    out.commanding = hook == HookState::Active;
    out.pitch_rad = 0.4;
    out.pump_cc = 200;
    judge.cycle({now, hook, 0.1, false, false, array, now, 100, 0, 14, true, &out});
  };
  cycle(4, HookState::Silent);
  EXPECT_EQ(judge.verdict().violation, "the mission does not give control back");
  cycle(8, HookState::Active);
  cycle(12, HookState::Silent);
  EXPECT_NE(judge.verdict().violation, "");
}

TEST(JudgeForEver, LooksNoLongerThanSomethingCanCome) {
  JudgeSetup setup;
  setup.faults.power = {{100, kForever}};
  setup.promise = promiseOf(FaultKind::Power);
  FlightJudge judge(setup);
  hooks::HookbehOutputs out;
  out.pitch_rad = 0.4;
  out.pump_cc = 200;
  const SensorArray array(shippedSetup("default").platform);
  double last = 0;
  for (double now = 0; now < 1000; now += kCycle) {
    const bool active = now < 132;
    out.commanding = active;
    if (!judge.cycle({now, active ? HookState::Active : HookState::Silent, now < 300 ? 10.0 : 0,
                      false, false, array, now, 100, 0, 14, true, &out})) {
      last = now;
      break;
    }
  }
  EXPECT_EQ(last, 300 + 60 + kCycle);
}

TEST(JudgedFlight, OfTheFakePilotIsGood) {
  for (uint32_t k = 0; k < kFaultKinds; ++k) {
    const FakePilot::Plan plan{.give_back_s = 1200, .takes_again = true};
    SimulationSetup setup = shippedSetup("default");
    const DrawnFaults drawn =
        drawFaults(static_cast<FaultKind>(k), Manner::Once, 5, {1200, 8, 1200, 20});
    drawn.applyTo(setup.scenario);
    setup.restart_sbc = [plan] {
      return support::Result<std::unique_ptr<SbcPort>>(std::make_unique<FakeSbc>(plan, 1e9, true));
    };
    setup.sbc = std::move(*setup.restart_sbc());
    FlightJudge judge(judgeSetup(setup.platform, setup.scenario, drawn.kinds));
    setup.onlooker = &judge;
    const support::Trace trace = fly(std::move(setup));
    EXPECT_NE(judge.verdict().outcome, Outcome::Violation)
        << nameOf(static_cast<FaultKind>(k)) << ": " << judge.verdict().violation << "\n"
        << eventText(trace);
  }
}

}  // namespace
}  // namespace glider::simulator
