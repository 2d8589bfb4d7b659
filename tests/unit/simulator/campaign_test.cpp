// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What a campaign draws, promises and sees.

#include "hooks/protocol/messages.h"
#include "simulator/campaign/draw_faults.h"
#include "simulator/slocum/own_mission.h"
#include "tests/slocum.h"
#include "tests/unit/simulator/fake_sbc.h"
#include "tests/unit/simulator/flights.h"
#include "vehicles/slocum/oracles/flight_judge.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

namespace glider::simulator {

using slocum::oracles::FlightJudge;
using slocum::oracles::JudgeSetup;
using slocum::oracles::judgeSetup;
using slocum::oracles::StatedTimes;
using slocum::oracles::statedTimes;
namespace {

using Outcome = Verdict::Outcome;

constexpr double kLag = 8;  // line_lag_s of the Slocum
constexpr double kSilence = 24, kCampaignCycle = 4;

constexpr FlightTimes kTimes = {1000, 30, 900, 30};

/// Something of what was drawn, as a number: two draws that are alike have the same.
double signature(const DrawnFaults& drawn) {
  double sum = drawn.water_depth_m.value_or(0) + (drawn.args ? drawn.args->max_depth_m : 0);
  sum += drawn.vehicle.altimeter_range_m + drawn.vehicle.pressure_every_s;
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
        EXPECT_TRUE(!drawn.faults.empty() || drawn.args || drawn.water_depth_m ||
                    drawn.vehicle.differs());
        EXPECT_TRUE(drawn.faults.empty() || drawn.faults.first() < 1100);
        EXPECT_EQ(signature(drawn), signature(drawFaults(kind, manner, seed, kTimes)));
        if (kind != FaultKind::NoCtd) {  // of which there is one only
          EXPECT_NE(signature(drawn), signature(drawFaults(kind, manner, seed + 100, kTimes)));
        }
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
    EXPECT_GE(draw(Manner::Exit).faults.first(), kTimes.release_s - 40);
    EXPECT_GE(draw(Manner::Recurring).faults.lines.size(), 2 * 3U);
    for (const LineFault& fault : draw(Manner::ForGood).faults.lines) {
      EXPECT_EQ(fault.when.to_s, kForever);
    }
    EXPECT_EQ(draw(Manner::Once).kinds.size(), 1U);
    EXPECT_GE(draw(Manner::Together).kinds.size(), 2U);
  }
}

/// What is wrong with the line, in words.
std::string wrongWith(const LineFault& fault) {
  std::string wrong;
  const auto add = [&wrong](bool is, const char* word) { wrong += is ? word : ""; };
  add(fault.cut, "cut");
  add(fault.loss > 0, "loss");
  add(fault.flips > 0, "flips");
  add(fault.bursts > 0, "bursts");
  add(fault.delay_s > 0, "delay");
  add(fault.doubled > 0, "doubled");
  add(fault.replayed > 0, "replayed");
  add(fault.heard_at_baud > 0, "baud");
  return wrong;
}

TEST(DrawFaults, EachKindOfTheLineIsThatAndNothingElse) {
  const std::pair<FaultKind, const char*> kinds[] = {
      {FaultKind::ByteLoss, "loss"},         {FaultKind::BitFlips, "flips"},
      {FaultKind::Bursts, "bursts"},         {FaultKind::Delay, "delay"},
      {FaultKind::DoubledFrames, "doubled"}, {FaultKind::OldFrames, "replayed"},
      {FaultKind::HalfOpen, "cut"},          {FaultKind::LineCut, "cut"},
      {FaultKind::BaudMismatch, "baud"},     {FaultKind::FlightScience, "cut"},
      {FaultKind::LateLine, "delay"}};
  for (const auto& [kind, wrong] : kinds) {
    for (uint64_t seed = 0; seed < 20; ++seed) {
      for (const LineFault& fault : drawFaults(kind, Manner::Once, seed, kTimes).faults.lines) {
        EXPECT_EQ(wrongWith(fault), wrong) << nameOf(kind);
        const bool of_flight = fault.way == LineWay::ToFlight || fault.way == LineWay::FromFlight;
        EXPECT_TRUE(!fault.cut || of_flight == (kind == FaultKind::FlightScience)) << nameOf(kind);
      }
    }
  }
}

TEST(DrawFaults, WhatIsDrawnIsAppliedToTheScenario) {
  const platforms::Platform platform = shippedSetup("default").platform;
  Scenario scenario = shippedSetup("default").scenario;
  const DrawnFaults tight = drawFaults(FaultKind::TightLimits, Manner::Once, 1, kTimes);
  tight.applyTo(platform, scenario);
  drawFaults(FaultKind::ShallowWater, Manner::Once, 1, kTimes).applyTo(platform, scenario);
  const JudgeSetup judged = judgeSetup(platform, scenario, {FaultKind::TightLimits});
  EXPECT_EQ(judged.args.greatest_depth_m, tight.args->max_depth_m);
  EXPECT_EQ(judged.args.start_secs, tight.args->start_secs);
  EXPECT_EQ(judged.overdepth_m, 70);
  EXPECT_LE(scenario.ocean.bottom.depth_m, 36);
}

TEST(DrawFaults, AVehicleThatDiffersIsAppliedToTheScenario) {
  const platforms::Platform platform = shippedSetup("default").platform;
  const auto judged = [&](FaultKind kind) {
    Scenario scenario = shippedSetup("default").scenario;
    const DrawnFaults drawn = drawFaults(kind, Manner::Once, 1, kTimes);
    EXPECT_EQ(drawn.lasts(), kind != FaultKind::None);
    drawn.applyTo(platform, scenario);
    return judgeSetup(platform, scenario, drawn.kinds);
  };
  EXPECT_FALSE(judged(FaultKind::NoCtd).has_ctd);
  EXPECT_GT(judged(FaultKind::DeafAltimeter).echo_every_s, 15);
  EXPECT_LE(judged(FaultKind::DeafAltimeter).echo_every_s, 80.1);
  const double late_m = judged(FaultKind::SlowPressure).late_m;
  EXPECT_GT(late_m, 0);
  EXPECT_LT(late_m, 12 * 0.44);
  EXPECT_EQ(judged(FaultKind::None).late_m, 0);
}

TEST(DrawFaults, BothPressuresFlickerTogetherAndOftenInAHover) {
  FlightTimes times = kTimes;
  times.hover = {300, 400};
  int in_hover = 0;
  for (uint64_t seed = 0; seed < 100; ++seed) {
    const auto& sensors =
        drawFaults(FaultKind::BothPressures, Manner::Once, seed, times).faults.sensors;
    ASSERT_EQ(sensors.size(), 4U);
    EXPECT_EQ(sensors[0].name, "m_pressure");
    EXPECT_EQ(sensors[2].name, "sci_water_pressure");
    EXPECT_EQ(sensors[1].value, sensors[3].value);
    EXPECT_EQ(sensors[0].when.from_s, sensors[2].when.from_s);
    in_hover += times.hover.has(sensors[0].when.from_s);
  }
  EXPECT_GT(in_hover, 40);
  EXPECT_LT(in_hover, 80);
}

TEST(DrawFaults, ASensorThatDriftsMaySwayAloneOrBesideAReadingThatIsStuck) {
  int drifts = 0, alone = 0, beside = 0;
  for (uint64_t seed = 0; seed < 200; ++seed) {
    const auto& sensors =
        drawFaults(FaultKind::SensorDrift, Manner::Once, seed, kTimes).faults.sensors;
    ASSERT_FALSE(sensors.empty());
    const bool sways = sensors.back().kind == SensorFault::Kind::Sways;
    drifts += !sways;
    alone += sways && sensors.size() == 1;
    beside += sways && sensors.size() == 2 && sensors[0].kind == SensorFault::Kind::Frozen;
    EXPECT_TRUE(!sways || (sensors.back().period_s >= 20 && sensors.back().period_s <= 400));
  }
  EXPECT_EQ(drifts + alone + beside, 200);
  EXPECT_GT(drifts, 50);
  EXPECT_GT(alone, 15);
  EXPECT_GT(beside, 15);
}

TEST(DrawFaults, SomeVehiclesWithAWrongSensorHaveNoCtd) {
  const auto without = [](FaultKind kind) {
    int count = 0;
    for (uint64_t seed = 0; seed < 100; ++seed) {
      count += drawFaults(kind, Manner::Once, seed, kTimes).vehicle.no_ctd;
    }
    return count;
  };
  EXPECT_GT(without(FaultKind::SensorFrozen), 10);
  EXPECT_LT(without(FaultKind::SensorFrozen), 40);
  EXPECT_EQ(without(FaultKind::SensorDrift), 0) << "nothing on board can see it";
  EXPECT_EQ(without(FaultKind::SensorScale), 0);
}

TEST(JudgeSetup, OfAnSbcThatMayBeSilentForLongIsWhatHookbehMakesOfIt) {
  const platforms::Platform platform = shippedSetup("default").platform;
  const auto silence = [&](double secs) {
    Scenario scenario = shippedSetup("default").scenario;
    for (slocum::BehaviourBlock& behaviour : missionFileOf(scenario).behaviours) {
      for (slocum::Setting& setting : behaviour.arguments) {
        setting.value = setting.name == "silence_secs" ? secs : setting.value;
      }
    }
    return judgeSetup(platform, scenario, {}).args.silence_secs;
  };
  EXPECT_EQ(silence(100), 100);
  EXPECT_EQ(silence(3600), 600);
}

TEST(Promises, AreThoseOfTheDocumentWordForWord) {
  std::ifstream file(std::string(GLIDER_SOURCE_DIR) + "/scenarios/README.md");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::string head =
      "| fault | the SBC's control | greatest true depth | clearance | commands followed |\n"
      "|---|---|---|---|---|\n";
  const size_t at = text.find(head);
  ASSERT_NE(at, std::string::npos);
  const size_t begin = at + head.size();
  EXPECT_EQ(text.substr(begin, text.find("\n\n", begin) + 1 - begin),
            promiseTable({kSilence, kCampaignCycle, kLag}));
}

TEST(Promises, OfFaultsThatComeTogetherAreTheWeaker) {
  const FaultKind sensors[] = {FaultKind::SensorFrozen, FaultKind::SensorNan};
  EXPECT_EQ(promiseOf(sensors).deepest, Deepest::OneAndAHalf);
  const FaultKind mixed[] = {FaultKind::Clock, FaultKind::SensorFrozen};
  EXPECT_EQ(promiseOf(mixed).deepest, Deepest::TenMetres);
  EXPECT_EQ(promiseOf(mixed).control, Control::Any);
  const FaultKind several[] = {FaultKind::Several, FaultKind::LineCut, FaultKind::Clock};
  EXPECT_EQ(promiseOf(several).deepest, Deepest::Overshoot) << "no sensor is among them";
  EXPECT_TRUE(promiseOf(several).follows);
  EXPECT_FALSE(promiseOf(mixed).clearance);
  const FaultKind lines[] = {FaultKind::LineCut, FaultKind::Clock};
  EXPECT_EQ(promiseOf(lines).control, Control::Silent);
  EXPECT_EQ(deepestAllowed(Deepest::Overshoot, 60), 65);
  EXPECT_EQ(deepestAllowed(Deepest::TenMetres, 60), 70);
  EXPECT_EQ(deepestAllowed(Deepest::OneAndAHalf, 60), 90);
}

TEST(Promises, FaultsOfTheWaterAndTheSensorsLeaveTheSbc) {
  for (const FaultKind kind :
       {FaultKind::None, FaultKind::LeftOver, FaultKind::SensorFrozen, FaultKind::ShallowWater}) {
    EXPECT_TRUE(leavesTheSbc(kind)) << nameOf(kind);
  }
  for (const FaultKind kind :
       {FaultKind::ByteLoss, FaultKind::LineCut, FaultKind::Power, FaultKind::FlightRestart,
        FaultKind::FlightAbort, FaultKind::Clock, FaultKind::HookSensor, FaultKind::Several}) {
    EXPECT_FALSE(leavesTheSbc(kind)) << nameOf(kind);
  }
}

TEST(StatedTimes, AreThoseOfTheWatchdogs) {
  Faults faults;
  faults.power = {{100, 200}};
  faults.lines = {{.when = {300, kForever}, .cut = true}, {.when = {0, 50}, .delay_s = 2}};
  faults.aborts = {500};
  const StatedTimes stated = statedTimes(faults, {kSilence, kCampaignCycle, kLag});
  ASSERT_EQ(stated.releases.size(), 3U);
  EXPECT_EQ(stated.releases[0].when.from_s, 100 + 40 + 2);
  EXPECT_EQ(stated.releases[0].when.to_s, 200);
  EXPECT_EQ(stated.releases[1].when.from_s, 300 + 40 + 2);
  EXPECT_EQ(stated.releases[2].when.from_s, 500);
  EXPECT_EQ(stated.most_standstill_s, 64 + 2);
}

TEST(JudgedFlight, OfTheFakePilotIsGood) {
  for (uint32_t k = 0; k < kFaultKinds; ++k) {
    const FakePilot::Plan plan{.release_s = 1200, .takes_again = true};
    SimulationSetup setup = shippedSetup("default");
    const DrawnFaults drawn =
        drawFaults(static_cast<FaultKind>(k), Manner::Once, 5, {1200, 8, 1200, 20});
    drawn.applyTo(setup.platform, setup.scenario);
    setup.restart_sbc = [plan] {
      return support::Result<std::unique_ptr<SbcPort>>(std::make_unique<FakeSbc>(plan, 1e9, true));
    };
    setup.sbc = std::move(*setup.restart_sbc());
    FlightJudge judge(judgeSetup(setup.platform, setup.scenario, drawn.kinds));
    setup.observer = &judge;
    const support::Trace trace = fly(std::move(setup));
    EXPECT_NE(judge.verdict().outcome, Outcome::Violation)
        << nameOf(static_cast<FaultKind>(k)) << ": " << judge.verdict().violation << "\n"
        << eventText(trace);
  }
}

}  // namespace
}  // namespace glider::simulator
