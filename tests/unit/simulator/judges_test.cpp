// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// For each check of a flight one planted loss that no other detects. Each row begins as the same
// good flight, which passes all checks, and plants its loss in what they observe: the vehicle,
// hookbeh or the SBC.

#include "hooks/hookbeh/hull.h"
#include "simulator/campaign/judge_limits.h"
#include "simulator/campaign/judge_table.h"
#include "tests/unit/simulator/judged.h"

#include <fstream>
#include <functional>
#include <iterator>

namespace glider::simulator {
namespace {

using hooks::HookGuard;
using hooks::HookState;

/// A vehicle that flies yos as commanded, until a loss is planted in it.
class GoodFlight {
 public:
  explicit GoodFlight(JudgeSetup setup = usual())
      : setup_(std::move(setup)), judge_(setup_), array_(shippedSetup("default").platform) {
    array_.set(GLIDER_X_HOOK_GUARD, 0);
    array_.set(GLIDER_X_HOOK_MASKED, 0);
  }

  static JudgeSetup usual() {
    JudgeSetup setup;
    // As under sensors that are wrong: whether instructions are followed is not checked.
    setup.promise = promiseOf(FaultKind::SensorStuck);
    setup.has_hookbeh = true;
    setup.args.greatest_depth_m = 60;
    setup.args.least_altitude_m = 5;
    setup.overdepth_m = 70;
    setup.undervolts = 10;
    setup.hull_m = 200;
    setup.pump_cc = hooks::kHull.pump_cc;
    setup.pump_out_j_cc = 0.29;
    setup.pump_out_j_cc_m = 0.018;
    setup.loads_W = 1.6;
    setup.through_water_mps = 0.6;
    setup.dictionary = slocumSensors();
    setup.mean_W = 3;
    return setup;
  }

  void say(hooks::Frame& frame) {
    frame.sequence = ++frames_;
    std::array<uint8_t, hooks::kMostEncodedBytes> bytes;
    judge_.said({bytes.data(), hooks::encodeFrame(frame, bytes.data())}, now_);
  }
  void instruct(uint32_t session, uint16_t sequence, hooks::HookControl control,
                hooks::HookVertical vertical, double depth, bool arrives = true) {
    hooks::Frame frame;
    hooks::encodeEmptyList(hooks::MessageType::Write, frame);
    const double pitch = vertical == hooks::HookVertical::Ascend ? 0.4538 : -0.4538;
    const std::pair<uint16_t, double> words[] = {
        {GLIDER_SCI_HOOK_SESSION, session},
        {GLIDER_SCI_HOOK_CONTROL, static_cast<double>(control)},
        {GLIDER_SCI_HOOK_VERTICAL, static_cast<double>(vertical)},
        {GLIDER_SCI_HOOK_DEPTH, depth},
        {GLIDER_SCI_HOOK_PITCH, pitch},
        {GLIDER_SCI_HOOK_LATERAL, 0},
        {GLIDER_SCI_HOOK_HEADING, 0},
        {GLIDER_SCI_HOOK_LAT, 0},
        {GLIDER_SCI_HOOK_LON, 0},
        {GLIDER_SCI_HOOK_CHECK, 7},
        {GLIDER_SCI_HOOK_SEQUENCE, sequence}};
    for (const auto& [id, value] : words) {
      ASSERT_TRUE(hooks::appendValue(frame, {id, value}));
      if (arrives) {
        array_.set(id, value);
      }
    }
    say(frame);
    if (arrives) {
      array_.set(GLIDER_X_HOOK_SESSION, session);
      array_.set(GLIDER_X_HOOK_SEQUENCE, sequence);
      array_.set(GLIDER_X_HOOK_ANSWER, static_cast<double>(hooks::HookAnswer::Accepted));
      newest_ = sequence;
    }
  }
  void take() {
    instruct(1, 1, hooks::HookControl::Take, hooks::HookVertical::Descend, 40);
    state_ = HookState::Active;
  }
  void steer(hooks::HookVertical vertical, double depth) {
    instruct(1, static_cast<uint16_t>(newest_ + 1), hooks::HookControl::Steer, vertical, depth);
  }
  /// One cycle of a flight between 4 and 40 m.
  void cycle() {
    now_ += kCycle;
    follow();
    tamper_(*this);
    const hooks::HookbehOutputs* hookbeh = aborted_ ? nullptr : &out_;
    out_.commanding = state_ == HookState::Active;
    array_.set(GLIDER_M_DEPTH, reading_ ? *reading_ : depth_);
    array_.set(GLIDER_X_HOOK_GUARD,
               reported_guard_ ? *reported_guard_ : static_cast<double>(out_.guard));
    array_.set(GLIDER_SCI_HOOK_HEARTBEAT, beats_ ? ++heartbeat_ : heartbeat_);
    array_.set(GLIDER_C_BALLAST_PUMPED, out_.pump_cc);
    array_.set(Sensor::c_pitch, out_.pitch_rad);
    if (talks_) {
      hooks::Frame frame;
      hooks::Done done;
      done.session = 1;
      done.status.mission_time_s = now_;
      hooks::encode(done, frame);
      say(frame);
    }
    used_J_ += power_W_ * kCycle;
    CycleView view{now_, state_,     depth_,  aborted_, ended_, array_,
                   now_, clearance_, used_J_, volts_,   true,   hookbeh};
    view.east_m = east_m_;
    view.pumped_cc = pumped_cc_;
    view.left_J = left_J_;
    judge_.cycle(view);
  }
  void fly(double seconds) {
    for (const double until_s = now_ + seconds; now_ < until_s;) {
      cycle();
    }
  }
  /// The same with `tamper` in each cycle.
  void fly(double seconds, const std::function<void(GoodFlight&)>& tamper) {
    tamper_ = tamper;
    fly(seconds);
    tamper_ = [](GoodFlight&) {};
  }
  void release() {
    instruct(1, static_cast<uint16_t>(newest_ + 1), hooks::HookControl::Release,
             hooks::HookVertical::None, 0);
    state_ = HookState::Complete;
  }
  /// Comes up and exits: the end of a good flight.
  void land() {
    if (state_ == HookState::Active) {
      release();
    }
    goal_m_ = 0;
    fly(60 + depth_ / 0.19);
  }
  [[nodiscard]] Verdict verdict() const { return judge_.verdict(); }

  // What a loss is planted in.
  double depth_ = 0.5, clearance_ = 100, power_W_ = 3, used_J_ = 0, volts_ = 14, left_J_ = 8e6;
  double east_m_ = 0, mps_ = 0.3, pumped_cc_ = 233;
  std::optional<double> reading_, reported_guard_, goal_m_, held_m_;
  bool beats_ = true, talks_ = true, aborted_ = false, ended_ = false, lands_ = true;
  bool guarded_ = false;
  std::function<void(GoodFlight&)> tamper_ = [](GoodFlight&) {
  };  ///< in each cycle, before it is seen
  HookState state_ = HookState::Ready;
  hooks::HookbehOutputs out_;
  double now_ = 0;

 private:
  /// Moves the vehicle, and commands what brings it there.
  void follow() {
    constexpr double kMps = 0.19;
    if (!goal_m_ && !guarded_ && ((down_ && depth_ >= 40) || (!down_ && depth_ <= 4))) {
      down_ = !down_;
      if (state_ == HookState::Active) {
        steer(down_ ? hooks::HookVertical::Descend : hooks::HookVertical::Ascend, down_ ? 40 : 4);
      }
    }
    const bool down = goal_m_ ? depth_ < *goal_m_ : down_ && !guarded_;
    const double left = goal_m_ ? std::fabs(depth_ - *goal_m_) : 1e9;
    depth_ += (down ? 1 : -1) * std::min(kMps * kCycle, left);
    depth_ = held_m_ ? *held_m_ : std::max(depth_, 0.5);
    east_m_ += mps_ * (state_ == HookState::Active ? kCycle : 0);
    out_.guard = guarded_ ? HookGuard::NoDepthGained : HookGuard::None;
    out_.doing = guarded_ ? "climb: no depth gained" : down ? "dive_to" : "climb_to";
    out_.pitch_rad = down ? -0.4538 : 0.4538;
    out_.pump_cc = down ? -230 : guarded_ ? hooks::kHull.pump_cc : 230;
    pumped_cc_ = out_.pump_cc;
  }

  JudgeSetup setup_;
  FlightJudge judge_;
  SensorArray array_;
  bool down_ = true;
  double heartbeat_ = 0;
  uint16_t newest_ = 0;
  uint8_t frames_ = 0;
};

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

/// A vehicle that stays at the surface under a commanded depth.
class JudgedAtSurface : public testing::Test {
 protected:
  std::string stay(double seconds, const std::function<void()>& each = [] {}) {
    hooks::Instruction in_force;
    in_force.vertical = hooks::HookVertical::Descend;
    in_force.depth_m = 40;
    std::string wrong;
    for (double passed = 0; passed < seconds && wrong.empty(); passed += kCycle) {
      now_ += kCycle;
      array_.beginCycle();
      depth_reading_m_ = 0.1 + 0.01 * (static_cast<int>(now_) % 3);
      ctd_bar_ = kNan;
      each();
      array_.set(GLIDER_M_DEPTH, depth_reading_m_);
      if (!std::isnan(ctd_bar_)) {
        array_.set(GLIDER_SCI_WATER_PRESSURE, ctd_bar_);
      }
      wrong = judge_.cycle({now_, hook_, 0.1, false, false, array_, now_, clearance_m_}, in_force);
    }
    return wrong;
  }
  static constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  JudgeSetup setup_ = GoodFlight::usual();
  SurfaceJudge judge_{setup_};
  SensorArray array_{shippedSetup("default").platform};
  HookState hook_ = HookState::Active;
  double now_ = 0, depth_reading_m_ = 0, ctd_bar_ = kNan, clearance_m_ = 100;
};

TEST_F(JudgedAtSurface, IsSeen) {
  EXPECT_EQ(stay(4000), "at the surface for 1804 s though 40 m is commanded");
}

TEST_F(JudgedAtSurface, IsRightAfterAJumpOfTheDepthThatNoCtdRefutes) {
  EXPECT_EQ(stay(100), "");
  EXPECT_EQ(stay(12, [&] { depth_reading_m_ = 30; }), "");
  EXPECT_EQ(stay(9000), "");
  EXPECT_EQ(stay(100, [&] { ctd_bar_ = depth_reading_m_ / 10; }), "");
  EXPECT_NE(stay(4000), "") << "the CTD has agreed for a minute";
}

TEST_F(JudgedAtSurface, IsSeenAfterAJumpTooShortToCount) {
  EXPECT_EQ(stay(100), "");
  EXPECT_EQ(stay(8, [&] { depth_reading_m_ = 30; }), "");
  EXPECT_NE(stay(4000), "");
}

TEST_F(JudgedAtSurface, IsSeenAfterARestartOfHookbeh) {
  EXPECT_EQ(stay(12, [&] { depth_reading_m_ = 30; }), "");
  EXPECT_EQ(stay(100), "");
  judge_.restart();
  EXPECT_NE(stay(4000), "");
}

TEST_F(JudgedAtSurface, IsRightBetweenRareEchoesInTwentyEightMetres) {
  setup_.echo_every_s = 80;
  clearance_m_ = 28;
  EXPECT_EQ(stay(4000), "");
  clearance_m_ = 32;
  EXPECT_NE(stay(4000), "");
}

TEST_F(JudgedAtSurface, IsNotItsFaultUnderAnSbcThatLosesControlAgainAndAgain) {
  for (int i = 0; i < 300; ++i) {
    hook_ = HookState::Active;
    EXPECT_EQ(stay(28), "");
    hook_ = HookState::Silent;
    EXPECT_EQ(stay(4), "");
  }
}

/// Contacts of a vehicle whose altimeter receives nothing.
class JudgedContacts : public testing::Test {
 protected:
  JudgedContacts() {
    setup_.promise = promiseOf(FaultKind::SensorMissing);
    setup_.faults.sensors.push_back({.name = "m_altitude", .kind = SensorFault::Kind::Missing});
  }
  std::string touch(double east_m, double water_m, double seconds = kCycle) {
    std::string wrong;
    for (double passed = 0; passed < seconds && wrong.empty(); passed += kCycle) {
      wrong = cycle(east_m, water_m, 0);
    }
    const std::string left = cycle(east_m, water_m, 20);
    return wrong.empty() ? left : wrong;
  }
  void flyClear(double seconds) {
    for (double passed = 0; passed < seconds; passed += kCycle) {
      (void)cycle(0, 40, 20);
    }
  }
  std::string cycle(double east_m, double water_m, double clearance_m) {
    now_ += kCycle;
    array_.set(GLIDER_M_DEPTH, water_m - clearance_m + reading_error_m_);
    CycleView view{now_, hook_, water_m - clearance_m, false, false, array_, now_, clearance_m};
    view.east_m = east_m;
    return judge_.cycle(view);
  }
  JudgeSetup setup_ = GoodFlight::usual();
  BottomJudge judge_{setup_};
  SensorArray array_{shippedSetup("default").platform};
  HookState hook_ = HookState::Active;
  double now_ = 0, reading_error_m_ = 0;
};

TEST_F(JudgedContacts, TheFirstIsOfABottomThatNobodyKnew) {
  EXPECT_EQ(touch(0, 40, 200), "");
  EXPECT_EQ(touch(3001, 40), "") << "another place";
}

TEST_F(JudgedContacts, TheSecondAtAPlaceIsSeen) {
  EXPECT_EQ(touch(0, 40, 60), "");
  EXPECT_EQ(touch(300, 40), "the vehicle is on the bottom again, 300 m from an earlier contact");
}

TEST_F(JudgedContacts, OfShortOnesTheFourthIsSeen) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(touch(100 * i, 40, 44), "") << i;
  }
  EXPECT_EQ(touch(300, 40), "the vehicle has touched the bottom 4 times here");
  EXPECT_EQ(touch(3400, 40), "") << "another place";
}

TEST_F(JudgedContacts, ShortOnesOverAShallowBottomAreNotCounted) {
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(touch(100 * i, 12, 44), "") << i;
  }
}

/// Rare echoes are enough for hookbeh only.
TEST_F(JudgedContacts, OfTheVehiclesOwnBehavioursAreNotHookbehs) {
  setup_.faults.sensors.clear();
  setup_.echo_every_s = 80;
  for (int i = 0; i < 3; ++i) {
    array_.beginCycle();
    array_.set(GLIDER_M_ALTITUDE, 20 + 0.1 * i);
    EXPECT_EQ(cycle(0, 40, 20), "");
  }
  array_.beginCycle();
  hook_ = HookState::Complete;
  EXPECT_EQ(touch(0, 40), "the vehicle is on the bottom") << "it may still be on its way";
  flyClear(60);
  EXPECT_EQ(touch(500, 40), "");
  setup_.echo_every_s = 4;
  EXPECT_EQ(touch(1000, 40), "the vehicle is on the bottom");
}

TEST_F(JudgedContacts, WhereTheBottomHasRisenItIsNotKnown) {
  EXPECT_EQ(touch(0, 40, 60), "");
  EXPECT_EQ(touch(300, 35, 60), "");
  EXPECT_NE(touch(400, 34), "");
}

TEST_F(JudgedContacts, OverAShallowBottomAreForgotten) {
  EXPECT_EQ(touch(0, 11, 60), "");
  flyClear(1000);
  EXPECT_NE(touch(0, 11), "");
  flyClear(1900);
  EXPECT_EQ(touch(0, 11), "");
}

TEST_F(JudgedContacts, RareEchoesShowTheBottomAfterThree) {
  setup_.faults.sensors.clear();
  setup_.echo_every_s = 80;
  EXPECT_EQ(touch(0, 40), "");
  for (int i = 0; i < 3; ++i) {
    array_.beginCycle();
    array_.set(GLIDER_M_ALTITUDE, 20 + 0.1 * i);
    EXPECT_EQ(cycle(3500, 40, 20), "");
  }
  array_.beginCycle();
  EXPECT_EQ(touch(7000, 40), "the vehicle is on the bottom");
}

TEST_F(JudgedContacts, AfterALongSilenceRareEchoesShowNoBottom) {
  setup_.faults.sensors.clear();
  setup_.echo_every_s = 80;
  for (const double silent_s : {600.0, 700.0}) {
    judge_.restart();
    for (int i = 0; i < 3; ++i) {
      array_.beginCycle();
      array_.set(GLIDER_M_ALTITUDE, 20 + 0.1 * i);
      EXPECT_EQ(cycle(0, 40, 20), "");
    }
    array_.beginCycle();
    flyClear(silent_s);
    EXPECT_EQ(touch(0, 40).empty(), silent_s > 640) << silent_s;
  }
  for (const double surface_s : {1000.0, 1204.0}) {
    array_.set(GLIDER_M_ALTITUDE, 20 + surface_s / 1e4);
    EXPECT_EQ(cycle(0, 40, 20), "");
    array_.beginCycle();
    now_ += surface_s;
    EXPECT_EQ(cycle(0, 42, 40), "");
    EXPECT_EQ(touch(9 * surface_s, 40).empty(), surface_s > 1200) << surface_s;
  }
}

/// Over so shallow a bottom hookbeh forgets an echo after ten minutes.
TEST_F(JudgedContacts, RareEchoesDoNotShowAShallowBottom) {
  setup_.faults.sensors.clear();
  setup_.echo_every_s = 80;
  for (int i = 0; i < 3; ++i) {
    array_.beginCycle();
    array_.set(GLIDER_M_ALTITUDE, 8 + 0.1 * i);
    EXPECT_EQ(cycle(0, 11, 8), "");
  }
  array_.beginCycle();
  EXPECT_EQ(touch(0, 11), "");
  EXPECT_EQ(touch(0, 13.5), "the vehicle is on the bottom");
}

/// Between rare echoes the vehicle may come nearer than min_altitude, between usual ones not.
TEST_F(JudgedContacts, RareEchoesPromiseNoClearance) {
  setup_.faults.sensors.clear();
  setup_.promise = promiseOf(FaultKind::None);
  for (const double every_s : {80.0, 4.0}) {
    setup_.echo_every_s = every_s;
    BottomJudge judge(setup_);
    std::string wrong;
    for (const double clearance_m : {20.0, 20.1, 20.2, 20.3, 0.7}) {
      now_ += kCycle;
      array_.beginCycle();
      array_.set(GLIDER_M_ALTITUDE, clearance_m);
      array_.set(GLIDER_M_DEPTH, 40 - clearance_m);
      wrong = judge.cycle({now_, hook_, 40 - clearance_m, false, false, array_, now_, clearance_m});
    }
    EXPECT_EQ(wrong.empty(), every_s > 20) << wrong;
  }
}

TEST_F(JudgedContacts, OneThatDoesNotEndIsSeen) {
  EXPECT_EQ(touch(0, 40, 700), "the vehicle has been on the bottom for 604 s");
}

TEST_F(JudgedContacts, AVehicleThatKnowsNoDepthCannotAvoidThem) {
  EXPECT_EQ(touch(0, 40), "");
  reading_error_m_ = 5;
  EXPECT_EQ(touch(10, 40), "");
}

TEST_F(JudgedContacts, ANewHookbehKnowsNoPlace) {
  EXPECT_EQ(touch(0, 40), "");
  judge_.restart();
  EXPECT_EQ(touch(10, 40), "");
}

TEST_F(JudgedContacts, AnAltimeterThatHearsAgainAvoidsAll) {
  setup_.faults.sensors.front().when.to_s = 100;
  now_ = 100 + 590;
  EXPECT_EQ(touch(0, 40), "") << "what it reported still counts";
  now_ = 100 + 601;
  EXPECT_EQ(touch(8000, 40), "the vehicle is on the bottom");
}

/// How often an altimeter of this range that loses this share of its echoes receives one, s.
double echoEvery(double range_m, double dropout, std::optional<double> period_s = {}) {
  Scenario scenario = shippedSetup("default").scenario;
  scenario.sensors.altimeter.range_m = range_m;
  scenario.sensors.altimeter.dropout = dropout;
  if (period_s) {
    slocum::Setting& setting = scenario.skeleton.sensors.emplace_back();
    setting.name = "c_alt_time";
    setting.value = *period_s;
  }
  return judgeSetup(shippedSetup("default").platform, scenario, {}).echo_every_s;
}

TEST(JudgeSetup, AnAltimeterOfRealLogsReceivesAnEchoInEightySeconds) {
  EXPECT_EQ(echoEvery(100, 0), 4);
  EXPECT_NEAR(echoEvery(36, 0.95), limits::kEchoEverySecs, 1e-6);
  EXPECT_EQ(echoEvery(100, 1), kForever);
  EXPECT_EQ(echoEvery(20, 0), kForever) << "the bottom comes too late";
  EXPECT_EQ(echoEvery(100, 0, -1), 4) << "hookbeh has it read";
}

TEST(JudgeSetup, ALongCycleIsNotATimeWithoutAFlightController) {
  Scenario scenario = shippedSetup("default").scenario;
  const auto is_dark = [&](double gap_s) {
    return judgeSetup(shippedSetup("default").platform, scenario, {}).isDark(gap_s);
  };
  EXPECT_FALSE(is_dark(12));
  EXPECT_TRUE(is_dark(15));
  scenario.cycles = {.mean_s = 4.4, .spread_s = 0.3, .long_share = 0.01, .long_s = 15};
  EXPECT_FALSE(is_dark(19));
  EXPECT_TRUE(is_dark(20));
}

TEST(JudgeSetup, KnowsSensorsByEitherName) {
  Scenario scenario = shippedSetup("default").scenario;
  scenario.faults.sensors.push_back({.name = "altitude", .kind = SensorFault::Kind::Missing});
  const JudgeSetup setup =
      judgeSetup(shippedSetup("default").platform, scenario, kindsOf(scenario.faults));
  EXPECT_EQ(setup.faults.sensors.front().name, "m_altitude");
}

TEST(JudgeSetup, ASensorThatIsStuckAndFlickersIsOneWrongSensor) {
  Scenario scenario = shippedSetup("default").scenario;
  scenario.faults.sensors.push_back({.name = "m_depth", .kind = SensorFault::Kind::Frozen});
  scenario.faults.sensors.push_back(
      {.name = "m_depth", .kind = SensorFault::Kind::Jumps, .value = 1});
  const auto promised = [&] {
    return judgeSetup(shippedSetup("default").platform, scenario, kindsOf(scenario.faults))
        .promise.deepest;
  };
  EXPECT_EQ(promised(), Deepest::TenMetres);
  scenario.faults.sensors.push_back({.name = "m_pitch", .kind = SensorFault::Kind::Frozen});
  EXPECT_EQ(promised(), Deepest::OneAndAHalf);
}

TEST(JudgeSetup, ASensorThatIsStuckAndSwaysDrifts) {
  Faults faults;
  faults.sensors.push_back({.name = "m_depth", .kind = SensorFault::Kind::Frozen});
  faults.sensors.push_back({.name = "m_depth", .kind = SensorFault::Kind::Sways, .value = 1});
  EXPECT_EQ(kindsOf(faults), std::vector{FaultKind::SensorDrift});
}

TEST(JudgeSetup, BeforeTheFirstSensorIsWrongAllIsPromised) {
  Scenario scenario = shippedSetup("default").scenario;
  scenario.faults.sensors.push_back(
      {.name = "m_depth", .when = {1000, 2000}, .kind = SensorFault::Kind::Missing});
  const JudgeSetup setup =
      judgeSetup(shippedSetup("default").platform, scenario, kindsOf(scenario.faults));
  EXPECT_TRUE(setup.promiseAt(999).follows);
  EXPECT_EQ(setup.promiseAt(999).control, Control::Kept);
  EXPECT_FALSE(setup.promiseAt(1000).follows);
  EXPECT_EQ(setup.promiseAt(1500).deepest, Deepest::TenMetres);
  EXPECT_EQ(setup.promiseAt(3801).deepest, Deepest::Overshoot);
  EXPECT_TRUE(setup.promiseAt(3801).clearance);
  EXPECT_FALSE(setup.promiseAt(3801).follows) << "what the mission has read still counts";
}

}  // namespace
}  // namespace glider::simulator
