// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The vehicle begins its own mission again while the SBC has no power: whether the SBC's goes on.

#include "runtime/checkpoint/checkpoint.h"
#include "tests/unit/runtime/resume_bench.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace glider::runtime::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class VehicleRestart : public ResumeBench {
 protected:
  VehicleRestart() { vehicle_.clock_at_start = 1.7e9; }

  /// The SBC is without power from 60 s on until `until`; the vehicle begins again at 72 s.
  void outage(double until) {
    boot(vehicle_);
    vehicle_.run(60);
    ASSERT_EQ(vehicle_.hookbeh().state, hooks::HookState::Active);
    began_ = vehicle_.now() - ticks_.back().time;
    while (ticks_.back().time > keptTime()) {
      ticks_.pop_back();
    }
    cutPower(vehicle_);
    vehicle_.run(72);
    vehicle_.restartMission();
    vehicle_.run(until);
    boot(vehicle_);
    vehicle_.run(until + 40);
  }

  double keptTime() {
    std::vector<double> memory(mission_.memory.size());
    GliderContext* kept = layOut(memory.data(), mission_.mission);
    LinkFacts facts;
    EXPECT_EQ(Checkpoint(store_.store(), 7).find(*kept, facts), Checkpoint::Found::Good);
    return kept->mission_time;
  }

  void expectBegunAnew() {
    EXPECT_THAT(logCsv(), Not(HasSubstr("mission resumed")));
    EXPECT_THAT(logCsv(), HasSubstr("the checkpoint is of an earlier flight"));
    EXPECT_EQ(vehicle_.hookbeh().state, hooks::HookState::Active);
    EXPECT_LT(gliderRuntimeContext(runtime_)->mission_time, 45);
  }

  /// The mission is over, also for a program that starts once more: unless the clock then shows a
  /// short outage.
  void expectLeft(const char* why, bool for_good = true) {
    EXPECT_THAT(logCsv(), HasSubstr("control left to the vehicle"));
    EXPECT_THAT(logCsv(), HasSubstr(why));
    EXPECT_THAT(logCsv(), Not(HasSubstr("mission resumed")));
    EXPECT_EQ(notes("the mission is over: the vehicle has restarted"), 1);
    expectNoControl();
    if (for_good) {
      boot(vehicle_);
      vehicle_.run(vehicle_.now() + 100);
      expectNoControl();
    }
  }

  void expectNoControl() {
    EXPECT_TRUE(finished_);
    EXPECT_EQ(gliderRuntimeContext(runtime_), nullptr);
    EXPECT_EQ(vehicle_.hookbeh().state, hooks::HookState::Ready);
  }

  [[nodiscard]] ptrdiff_t notes(const std::string& text) const {
    return std::ranges::count_if(vehicle_.events, [&](const hooks::SeatEvent& e) {
      return e.kind == hooks::SeatEvent::Kind::SbcNote && e.text == text;
    });
  }

  VehicleBench vehicle_{{.silence_secs = 24}};
  static constexpr int kOutage = 28;  ///< from the checkpoint at 52 s to the frame at 80 s
  double began_ = 0;  ///< vehicle's bench time at which mission time was 0, within a cycle
};

TEST_F(VehicleRestart, TheMissionContinuesAsIfItHadOnlyReceivedNothing) {
  outage(100);
  EXPECT_THAT(logCsv(), HasSubstr("mission resumed"));
  EXPECT_EQ(vehicle_.hookbeh().state, hooks::HookState::Active) << "taken with a new handshake";
  EXPECT_NEAR(ticks_.back().time, vehicle_.now() - began_, 4.0) << "mission time counts on";
  vehicle_.run(700);
  EXPECT_TRUE(finished_);
  EXPECT_EQ(vehicle_.hookbeh().state, hooks::HookState::Complete);
  const auto expected = undisturbed(ticks_);
  for (size_t i = 0; i < ticks_.size(); ++i) {
    ASSERT_EQ(ticks_[i].body, expected[i]) << "tick of " << ticks_[i].time << " s";
    ASSERT_TRUE(i == 0 || ticks_[i].time > ticks_[i - 1].time);
  }
}

TEST_F(VehicleRestart, AMissionThatMustNotContinueAfterItIsOver) {
  mission_.mission.new_after_restart = 1;
  outage(100);
  expectLeft("the vehicle has restarted its mission");
}

TEST_F(VehicleRestart, AfterTooLongAnOutageTheMissionIsOver) {
  outage(60 + 120 + 24);
  expectLeft("the outage was too long");
}

TEST_F(VehicleRestart, AfterAnOutageOfUnknownLengthTheMissionIsOver) {
  vehicle_.clock_at_start = 0;
  outage(100);
  expectLeft("the length of the outage is not known");
}

TEST_F(VehicleRestart, AfterHalfADayItIsAnotherFlightAndTheMissionBegins) {
  outage(60 + 12 * 3600 + 24);
  expectBegunAnew();
}

TEST_F(VehicleRestart, AfterALittleLessThanHalfADayTheMissionIsOver) {
  outage(60 + 12 * 3600 - 40);
  expectLeft("the outage was too long");
}

TEST_F(VehicleRestart, AMissionThatMayResumeWithinADayContinues) {
  mission_.mission.resume_within = 24 * 3600;
  outage(60 + 13 * 3600);
  EXPECT_THAT(logCsv(), HasSubstr("mission resumed"));
}

TEST_F(VehicleRestart, SeveralRestartsInOneOutageAreAsOne) {
  boot(vehicle_);
  vehicle_.run(60);
  cutPower(vehicle_);
  for (const double at : {64.0, 72.0, 88.0}) {
    vehicle_.run(at);
    vehicle_.restartMission();
  }
  boot(vehicle_);
  vehicle_.run(130);
  EXPECT_THAT(logCsv(), HasSubstr("mission resumed"));
  EXPECT_EQ(vehicle_.hookbeh().state, hooks::HookState::Active);
}

TEST_F(VehicleRestart, WhileTheSbcHasPowerTheMissionContinuesWhateverItSays) {
  mission_.mission.new_after_restart = 1;
  boot(vehicle_);
  vehicle_.run(60);
  const double before = ticks_.back().time;
  vehicle_.restartMission();
  vehicle_.run(120);
  EXPECT_EQ(vehicle_.hookbeh().state, hooks::HookState::Active);
  EXPECT_GT(ticks_.back().time, before);
}

TEST_F(VehicleRestart, WhenTheClockWasSetBackTheMissionIsOver) {
  boot(vehicle_);
  vehicle_.run(60);
  cutPower(vehicle_);
  vehicle_.restartMission();
  vehicle_.clock_at_start -= 1000;
  vehicle_.run(80);
  boot(vehicle_);
  vehicle_.run(110);
  expectLeft("the checkpoint is from the future");
}

/// By how much the vehicle's clock is set back, s.
class ClockSetBack : public VehicleRestart, public ::testing::WithParamInterface<int> {};

TEST_P(ClockSetBack, AnOutageOfNoTimeIsResumed) {
  boot(vehicle_);
  vehicle_.run(60);
  cutPower(vehicle_);
  vehicle_.restartMission();
  vehicle_.clock_at_start -= GetParam();
  vehicle_.run(80);
  boot(vehicle_);
  vehicle_.run(110);
  const double outage = kOutage - GetParam();
  if (outage < 0) {
    expectLeft("the checkpoint is from the future", false);
  } else {
    EXPECT_THAT(logCsv(), HasSubstr("mission resumed," + std::to_string(kOutage - GetParam())));
  }
}

INSTANTIATE_TEST_SUITE_P(Boots, ClockSetBack, ::testing::Range(16, 44, 4));

TEST_F(VehicleRestart, AFinishedMissionBeginsAgain) {
  end = 60;
  boot(vehicle_);
  vehicle_.run(90);
  ASSERT_TRUE(finished_);
  vehicle_.restartMission();
  end = 400;
  boot(vehicle_);
  vehicle_.run(120);
  EXPECT_FALSE(finished_);
  expectBegunAnew();
}

TEST_F(VehicleRestart, AnotherPowerCutAfterItIsResumedToo) {
  outage(100);
  cutPower(vehicle_);
  vehicle_.run(150);
  boot(vehicle_);
  vehicle_.run(200);
  EXPECT_EQ(vehicle_.hookbeh().state, hooks::HookState::Active);
  EXPECT_NEAR(ticks_.back().time, vehicle_.now() - began_, 4.0);
}

}  // namespace
}  // namespace glider::runtime::testing
