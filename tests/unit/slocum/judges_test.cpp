// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// For each check of a flight one planted loss that no other detects. Each row begins as the same
// good flight, which passes all checks, and plants its loss in what they observe: the vehicle,
// hookbeh or the SBC.

#include "tests/unit/slocum/good_flight.h"
#include "vehicles/slocum/oracles/judge_limits.h"
#include "vehicles/slocum/oracles/judge_table.h"

#include <fstream>
#include <functional>
#include <iterator>

namespace glider::slocum::oracles {
namespace {

using hooks::HookGuard;
using hooks::HookState;

struct Loss {
  JudgeId judge;
  const char* what;
  std::function<void(GoodFlight&)> plant;
};

// size: a table, a row for each check
const std::vector<Loss>& losses() {
  static const std::vector<Loss> kLosses = {
      {JudgeId::Instructions, "two instructions have one number",
       [](GoodFlight& f) {
         f.instruct(1, 40, hooks::HookControl::Steer, hooks::HookVertical::Descend, 40);
         f.cycle();
         f.instruct(1, 40, hooks::HookControl::Steer, hooks::HookVertical::Descend, 30);
         f.cycle();
       }},
      {JudgeId::Times, "the mission does not advance, and control goes on",
       [](GoodFlight& f) {
         f.talks_ = false;
         f.fly(100);
         f.talks_ = true;
       }},
      {JudgeId::Handshake, "after silence the SBC asks in vain",
       [](GoodFlight& f) {
         f.state_ = HookState::Silent;
         f.goal_m_ = 0.5;
         for (int i = 0; i < 60; ++i) {
           f.instruct(2, 50, hooks::HookControl::Take, hooks::HookVertical::Descend, 40, false);
           f.cycle();
         }
       }},
      {JudgeId::Commands, "a pitch past max_pitch",
       [](GoodFlight& f) { f.fly(8, [](GoodFlight& flight) { flight.out_.pitch_rad = 0.7; }); }},
      {JudgeId::Guards, "the heart stops beating, and control goes on",
       [](GoodFlight& f) {
         f.beats_ = false;
         f.fly(60);
         f.beats_ = true;
       }},
      {JudgeId::Needless, "a guard makes it climb again and again, and nothing is wrong",
       [](GoodFlight& f) {
         for (int i = 0; i < 6; ++i) {
           f.fly(320);
           f.guarded_ = true;
           f.fly(20);
           f.guarded_ = false;
         }
       }},
      {JudgeId::Depth, "the vehicle is deep, and its sensor does not report it",
       [](GoodFlight& f) {
         f.goal_m_ = 0.5;
         f.fly(40);
         f.reading_ = 20;
         f.fly(8, [](GoodFlight& flight) { flight.depth_ = 71; });
         f.reading_.reset();
       }},
      {JudgeId::Bottom, "the vehicle touches a bottom within the range of its altimeter",
       [](GoodFlight& f) {
         f.fly(60, [](GoodFlight& flight) { flight.clearance_ = 0; });
         f.clearance_ = 100;
       }},
      {JudgeId::Ascent, "without the SBC it stays under water",
       [](GoodFlight& f) {
         f.state_ = HookState::Silent;
         f.held_m_ = 10;
         f.fly(400);
         f.held_m_.reset();
       }},
      {JudgeId::Battery, "a dive goes on with less than the way up takes",
       [](GoodFlight& f) {
         f.left_J_ = 300;
         f.fly(100);
         f.left_J_ = 8e6;
       }},
      {JudgeId::Pump, "the pump moves back and forth in each cycle",
       [](GoodFlight& f) {
         bool out = false;
         f.fly(3600, [&out](GoodFlight& flight) {
           out = !out;
           flight.pumped_cc_ = out ? 75 : -75;
         });
       }},
      {JudgeId::Position, "it floats without control, faster than the current",
       [](GoodFlight& f) {
         f.land();
         f.fly(200, [](GoodFlight& flight) { flight.east_m_ += 2; });
       }},
      {JudgeId::Surface, "it stays at the surface though a depth is commanded",
       [](GoodFlight& f) {
         f.steer(hooks::HookVertical::Descend, 40);
         f.goal_m_ = 0.5;
         f.fly(3600);
       }},
      {JudgeId::Ending, "the mission does not end", [](GoodFlight& f) { f.lands_ = false; }},
  };
  return kLosses;
}

std::string found(const Verdict& verdict) {
  std::string text;
  for (const Violation& violation : verdict.violations) {
    text += std::string(nameOf(violation.judge)) + ": " + violation.what + "\n";
  }
  return text;
}

TEST(Judges, OfAGoodFlightSayNothing) {
  GoodFlight flight;
  flight.fly(8);
  flight.take();
  flight.fly(4000);
  flight.land();
  EXPECT_EQ(flight.verdict().outcome, Verdict::Outcome::Exited);
  EXPECT_EQ(found(flight.verdict()), "");
}

TEST(Judges, SeeEachPlantedLossAndOnlyOneOfThemDoes) {
  for (const Loss& loss : losses()) {
    GoodFlight flight;
    flight.fly(8);
    flight.take();
    flight.fly(60);
    loss.plant(flight);
    if (flight.lands_) {
      flight.land();
    }
    const Verdict verdict = flight.verdict();
    ASSERT_EQ(verdict.violations.size(), 1U) << loss.what << "\n" << found(verdict);
    EXPECT_EQ(verdict.violations.front().judge, loss.judge) << loss.what << "\n" << found(verdict);
    EXPECT_EQ(verdict.outcome, Verdict::Outcome::Violation);
  }
}

TEST(Judges, HaveAPlantedLossEach) {
  for (uint32_t i = 0; i < kJudges; ++i) {
    if (static_cast<JudgeId>(i) == JudgeId::Naps) {
      continue;  // checked on the SBC: nap_watch_test.cpp
    }
    EXPECT_EQ(std::ranges::count(losses(), static_cast<JudgeId>(i), &Loss::judge), 1)
        << nameOf(static_cast<JudgeId>(i));
  }
}

TEST(Judges, AllowWhatTheDocumentSaysWordForWord) {
  std::ifstream file(std::string(GLIDER_SOURCE_DIR) + "/scenarios/README.md");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::string head = "| check | a violation |\n|---|---|\n";
  const size_t at = text.find(head);
  ASSERT_NE(at, std::string::npos);
  const size_t begin = at + head.size();
  EXPECT_EQ(text.substr(begin, text.find("\n\n", begin) + 1 - begin), judgeTable());
}

// What is not excused.

/// True if a vehicle may be `after_m` deep after the flight controller was down for
/// 100 s, from 59 m on with these commands.
bool isCleanAfterRestart(double pitch_rad, double pump_cc, double after_m) {
  JudgeSetup setup = GoodFlight::usual();
  setup.promise = promiseOf(FaultKind::FlightRestart);
  DepthJudge judge(setup);
  SensorArray array(shippedSetup("default").platform);
  array.set(Sensor::c_pitch, pitch_rad);
  array.set(GLIDER_C_BALLAST_PUMPED, pump_cc);
  double now = 0;
  for (double depth = 4; depth < 60; depth += 1) {
    now += kCycle;
    EXPECT_EQ(judge.cycle({now, HookState::Ready, depth, false, false, array, now}), "");
  }
  now += 100;
  return judge.cycle({now, HookState::Ready, after_m, false, false, array, now}).empty();
}

double deepestAfterRestart(double pitch_rad, double pump_cc) {
  double depth = 60;
  while (depth < 190 && isCleanAfterRestart(pitch_rad, pump_cc, depth + 0.5)) {
    depth += 0.5;
  }
  return depth;
}

TEST(JudgedRestart, SinksAsFarAsItsCommandsTakeIt) {
  // From 59 m: 0.254 m/s at 26 degrees for 100 s and a cycle, and 7 m.
  EXPECT_NEAR(deepestAfterRestart(-0.4538, -230), 59 + 0.254 * 104 + 7, 0.6);
  EXPECT_NEAR(deepestAfterRestart(-0.7854, -230), 59 + 0.44 * 104 + 7, 0.6);
  EXPECT_NEAR(deepestAfterRestart(0, 0), 59 + 0.1 * 104 + 7, 0.6);
  EXPECT_EQ(deepestAfterRestart(0.4538, 230), 75) << "overdepth and 5 m";
}

TEST(JudgedRestart, AddsNothingByBeingRepeated) {
  JudgeSetup setup = GoodFlight::usual();
  setup.promise = promiseOf(FaultKind::FlightRestart);
  DepthJudge judge(setup);
  SensorArray array(shippedSetup("default").platform);
  array.set(Sensor::c_pitch, 0.45);
  array.set(GLIDER_C_BALLAST_PUMPED, 230);
  double now = 0;
  bool clean = true;
  for (double depth = 60; clean && depth < 190; depth += 0.5) {  // climbs, it says, and sinks
    now += 40;
    clean = judge.cycle({now, HookState::Ready, depth, false, false, array, now}).empty();
    EXPECT_LT(depth, 83) << "70 m, 5 m and 7 m";
  }
  EXPECT_FALSE(clean);
}

TEST(JudgedRestart, DoesNotExcuseADiveThatGoesOnBelowTheLimit) {
  JudgeSetup setup = GoodFlight::usual();
  setup.promise = promiseOf(FaultKind::FlightRestart);
  DepthJudge judge(setup);
  SensorArray array(shippedSetup("default").platform);
  array.set(Sensor::c_pitch, -0.45);
  array.set(GLIDER_C_BALLAST_PUMPED, -230);
  double now = 0, depth = 50;
  bool clean = true;
  for (; clean && depth < 190; depth += 10) {
    now += 40;
    clean = judge.cycle({now, HookState::Ready, depth, false, false, array, now}).empty();
  }
  EXPECT_LT(depth, 120) << "one restart from 75 m at most";
}

TEST(JudgedDepth, FlappingControlAddsNothing) {
  JudgeSetup setup = GoodFlight::usual();
  setup.promise = promiseOf(FaultKind::Power);
  DepthJudge judge(setup);
  SensorArray array(shippedSetup("default").platform);
  double now = 0;
  bool clean = true;
  double depth = 60;
  for (int i = 0; clean && depth < 190; ++i, depth += 0.5) {
    now += kCycle;
    const HookState hook = i % 2 == 0 ? HookState::Active : HookState::Silent;
    clean = judge.cycle({now, hook, depth, false, false, array, now}).empty();
  }
  EXPECT_LT(depth, 77) << "overdepth and 5 m, however often control changes";
}

/// At the surface a depth that is stuck near zero is right by chance.
TEST(JudgedNeedless, AGuardIsNeededWhileTheDepthIsWrong) {
  for (const bool wrong : {false, true}) {
    JudgeSetup setup = GoodFlight::usual();
    if (wrong) {
      setup.faults.sensors.push_back(
          {.name = "m_depth", .when = {900, 1e9}, .kind = SensorFault::Kind::Frozen});
    }
    GoodFlight flight(setup);
    flight.fly(8);
    flight.take();
    flight.fly(800);
    flight.guarded_ = true;
    flight.fly(1600);
    const auto& violations = flight.verdict().violations;
    EXPECT_EQ(std::ranges::count(violations, JudgeId::Needless, &Violation::judge), wrong ? 0 : 1)
        << found(flight.verdict());
  }
}

/// A depth that has just frozen is still near the truth.
TEST(JudgedNeedless, AGuardIsNeededAsSoonAsTheDepthIsFrozen) {
  for (const bool frozen : {false, true}) {
    JudgeSetup setup = GoodFlight::usual();
    for (double from_s = 1000; frozen && from_s < 9000; from_s += 1000) {
      setup.faults.sensors.push_back(
          {.name = "m_depth", .when = {from_s, from_s + 60}, .kind = SensorFault::Kind::Frozen});
    }
    GoodFlight flight(setup);
    flight.fly(8);
    flight.take();
    for (double from_s = 1000; from_s < 9000; from_s += 1000) {
      flight.fly(from_s + 20 - flight.now_);
      flight.fly(60, [](GoodFlight& guarded) {
        guarded.out_.guard = HookGuard::DepthFrozen;
        guarded.out_.doing = hooks::Doing::DepthFrozen;
      });
    }
    const auto& violations = flight.verdict().violations;
    EXPECT_EQ(std::ranges::count(violations, JudgeId::Needless, &Violation::judge), frozen ? 0 : 1)
        << found(flight.verdict());
  }
}

/// A mission that flips its commands counts, unless a sensor is wrong.
TEST(JudgedPumpDuty, OfAMissionThatIsMisledIsNotHookbehs) {
  for (const bool wrong : {false, true}) {
    JudgeSetup setup = GoodFlight::usual();
    if (wrong) {
      setup.faults.sensors.push_back({.name = "m_depth", .kind = SensorFault::Kind::Scale});
    }
    GoodFlight flight(setup);
    flight.fly(8);
    flight.take();
    flight.fly(60);
    bool out = false;
    for (int i = 0; i < 900; ++i) {
      out = !out;
      flight.steer(hooks::HookVertical::Descend, out ? 40 : 39);
      flight.fly(kCycle, [&](GoodFlight& f) { f.pumped_cc_ = out ? 75 : -75; });
    }
    const auto& violations = flight.verdict().violations;
    EXPECT_EQ(std::ranges::count(violations, JudgeId::Pump, &Violation::judge), wrong ? 0 : 1)
        << found(flight.verdict());
  }
}

}  // namespace
}  // namespace glider::slocum::oracles
