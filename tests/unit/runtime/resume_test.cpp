// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The SBC loses its power in flight: from what that leaves of the checkpoints the mission continues
// as if it had only received nothing in the meantime.

#include "runtime/checkpoint/checkpoint.h"
#include "tests/unit/runtime/resume_bench.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace glider::runtime::testing {
namespace {

using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::Not;

class ResumeTest : public ResumeBench {};

/// When the power goes, and for how long.
struct Outage {
  double at, lasts;
  bool counts;
  /// Prints the fields, without their padding.
  friend std::ostream& operator<<(std::ostream& out, const Outage& outage) {
    return out << outage.lasts << " s at " << outage.at << (outage.counts ? ", counting" : "");
  }
};

class Outages : public ResumeBench, public ::testing::WithParamInterface<Outage> {};

TEST_P(Outages, TheMissionContinuesAsIfItHadOnlyReceivedNothing) {
  const auto [at, lasts, every_tick] = GetParam();
  counts = every_tick;
  VehicleBench vehicle({.silence_secs = 24});
  boot(vehicle);
  vehicle.run(at);
  ASSERT_FALSE(ticks_.empty());
  // Ticks since the last that was kept are as if never received.
  std::vector<double> memory(mission_.memory.size());
  GliderContext* kept = layOut(memory.data(), mission_.mission);
  LinkFacts facts;
  ASSERT_EQ(Checkpoint(store_.store(), 7).find(*kept, facts), Checkpoint::Found::Good);
  EXPECT_GE(kept->mission_time, ticks_.back().time - (counts ? 0 : Checkpoint::kMostApart));
  while (ticks_.back().time > kept->mission_time) {
    ticks_.pop_back();
  }
  EXPECT_EQ(ticks_.back().body, bodyOf(*kept));
  cutPower(vehicle);
  vehicle.run(at + lasts);
  const size_t before = ticks_.size();
  boot(vehicle);
  vehicle.run(at + lasts + 12);
  ASSERT_GT(ticks_.size(), before) << "within a cycle of the link";
  EXPECT_THAT(logCsv(), HasSubstr("mission resumed"));
  vehicle.run(700);
  EXPECT_TRUE(finished_);
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Complete) << "released by the mission";
  const auto expected = undisturbed(ticks_);
  for (size_t i = 0; i < ticks_.size(); ++i) {
    ASSERT_EQ(ticks_[i].body, expected[i]) << "tick of " << ticks_[i].time << " s";
  }
  EXPECT_THAT(vehicle.answers, Each(hooks::HookAnswer::Accepted));
  if (lasts < 16) {
    EXPECT_THAT(logCsv(), Not(HasSubstr("control lost")));
  }
}

INSTANTIATE_TEST_SUITE_P(, Outages,
                         ::testing::Values(Outage{30, 3, true}, Outage{50, 9, false},
                                           Outage{101, 5, true}, Outage{105, 14, false},
                                           Outage{130, 60, true}, Outage{150, 100, false},
                                           Outage{158, 8, false}, Outage{230, 90, true}));

TEST_F(ResumeTest, AShortOutageContinuesInTheSameSessionAndHookbehNeverEndsControl) {
  VehicleBench vehicle({.silence_secs = 24});
  boot(vehicle);
  vehicle.run(60);
  const uint32_t session = vehicle.hookbeh().session;
  cutPower(vehicle);
  vehicle.run(68);
  boot(vehicle);
  for (double t = 69; t < 300; ++t) {
    vehicle.run(t);
    ASSERT_EQ(vehicle.hookbeh().state, hooks::HookState::Active) << t;
    ASSERT_EQ(vehicle.hookbeh().session, session) << t;
  }
}

TEST_F(ResumeTest, AfterSilenceControlIsTakenOnlyByANewHandshake) {
  VehicleBench vehicle({.silence_secs = 24});
  boot(vehicle);
  vehicle.run(60);
  const uint32_t session = vehicle.hookbeh().session;
  cutPower(vehicle);
  vehicle.run(120);
  ASSERT_EQ(vehicle.hookbeh().state, hooks::HookState::Silent);
  boot(vehicle);
  vehicle.run(150);
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Active);
  EXPECT_GT(vehicle.hookbeh().session, session);
}

TEST_F(ResumeTest, AfterAnOutageLongerThanTheMissionAllowsControlStaysWithTheVehicle) {
  VehicleBench vehicle({.silence_secs = 24});
  boot(vehicle);
  vehicle.run(60);
  cutPower(vehicle);
  vehicle.run(200);
  boot(vehicle);
  vehicle.run(300);
  EXPECT_TRUE(finished_);
  EXPECT_EQ(gliderRuntimeContext(runtime_), nullptr);
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Silent);
  EXPECT_THAT(logCsv(), HasSubstr("control left to the vehicle"));
  boot(vehicle);  // and again: it stays so
  vehicle.run(400);
  EXPECT_TRUE(finished_);
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Silent);
}

/// The mission resumes within 120 s, and after 120 s to the second.
class AtTheLimit : public ResumeBench, public ::testing::WithParamInterface<int> {};

TEST_P(AtTheLimit, AnOutageOfExactlyTheTimeIsResumed) {
  VehicleBench vehicle({.silence_secs = 24});
  boot(vehicle);
  vehicle.run(60);
  cutPower(vehicle);
  vehicle.run(GetParam());
  boot(vehicle);
  vehicle.run(GetParam() + 40);
  const std::string log = logCsv();
  const bool resumed = log.find("mission resumed") != std::string::npos;
  const bool left = log.find("control left to the vehicle") != std::string::npos;
  EXPECT_NE(resumed, left) << log;
  // Its line: event, seconds of the outage, why.
  const std::string event = resumed ? "mission resumed," : "control left to the vehicle,";
  const double outage = std::stod(log.substr(log.find(event) + event.size()));
  EXPECT_EQ(resumed, outage <= 120) << outage;
  EXPECT_EQ(outage, GetParam() - 52) << "the first tick is 8 s after, the newest checkpoint of 60";
}

INSTANTIATE_TEST_SUITE_P(Boots, AtTheLimit, ::testing::Range(160, 192, 4));

TEST_F(ResumeTest, AMissionThatNeverResumesReleasesEvenASessionThatIsStillObeyed) {
  mission_.mission.resume_within = 0;
  VehicleBench vehicle({.silence_secs = 24});
  boot(vehicle);
  vehicle.run(60);
  cutPower(vehicle);
  vehicle.run(65);
  boot(vehicle);
  vehicle.run(140);
  EXPECT_TRUE(finished_);
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Silent);
}

TEST_F(ResumeTest, AnotherFlightOfTheVehicleRestartsTheMission) {
  constexpr double kNextDay = 24 * 3600;
  {
    VehicleBench first({.silence_secs = 24});
    first.clock_at_start = 1.7e9;
    boot(first);
    first.run(60);
  }
  VehicleBench second({.silence_secs = 24});
  second.clock_at_start = 1.7e9 + kNextDay;
  boot(second);
  second.run(40);
  EXPECT_EQ(second.hookbeh().state, hooks::HookState::Active);
  EXPECT_LT(gliderRuntimeContext(runtime_)->mission_time, 40);
  EXPECT_THAT(logCsv(), HasSubstr("the checkpoint is of an earlier flight"));
  cutPower(second);
  second.run(50);
  boot(second);
  second.run(70);
  EXPECT_THAT(logCsv(), HasSubstr("mission resumed")) << "the newest one is the second flight's";
}

TEST_F(ResumeTest, ACheckpointFromTheFutureLeavesControlToTheVehicle) {
  {
    VehicleBench first({.silence_secs = 24});
    boot(first);
    first.run(300);
  }
  VehicleBench second({.silence_secs = 24});
  keeps = false;
  boot(second);
  second.run(60);
  ASSERT_EQ(second.hookbeh().state, hooks::HookState::Active);
  keeps = true;
  boot(second);
  second.run(120);
  EXPECT_TRUE(finished_);
  EXPECT_THAT(logCsv(), HasSubstr("the checkpoint is from the future"));
  EXPECT_EQ(second.hookbeh().state, hooks::HookState::Silent);
}

TEST_F(ResumeTest, ACheckpointOfAnotherProgramIsNotTaken) {
  VehicleBench vehicle({.silence_secs = 24});
  boot(vehicle, 7);
  vehicle.run(60);
  boot(vehicle, 8);
  vehicle.run(140);
  EXPECT_THAT(logCsv(), HasSubstr("the checkpoint is another program's"));
  EXPECT_THAT(logCsv(), Not(HasSubstr("mission resumed")));
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Active) << "after the silence";
}

TEST_F(ResumeTest, WithOtherParametersItIsAnotherProgram) {
  double chosen[] = {12};
  mission_.parameters = {{"bottom", 12, 0, 100, "m=3ff0000000000000"}};
  mission_.finish(1);
  std::vector<double> memory(mission_.memory.size());
  const auto found = [&] {
    const GliderRuntimeOptions options{
        {this, &ResumeTest::writeLog, nullptr, nullptr}, chosen, store_.store(), 7};
    runtime_memory_.assign(gliderRuntimeSize() / sizeof(double) + 1, 0.0);
    log_text_.clear();
    finished_ = false;
    runtime_ = gliderRuntimeInit(runtime_memory_.data(), mission_.memory.data(), &mission_.mission,
                                 &options);
    VehicleBench vehicle({.silence_secs = 24});
    vehicle.sbc = [&] { poll(vehicle); };
    vehicle.run(30);
    return logCsv();
  };
  EXPECT_THAT(found(), Not(HasSubstr("mission restarted")));
  EXPECT_THAT(found(), HasSubstr("control left to the vehicle"));
  chosen[0] = 13;
  EXPECT_THAT(found(), HasSubstr("another program's"));
}

TEST_F(ResumeTest, DamagedCheckpointsRestartTheMissionAndAreReported) {
  VehicleBench vehicle({.silence_secs = 24});
  boot(vehicle);
  vehicle.run(60);
  cutPower(vehicle);
  store_.content.eachByte([](uint32_t place, uint8_t& byte) {
    byte = static_cast<uint8_t>(byte ^ (place % 100 == 60 ? 0x10U : 0U));
  });
  boot(vehicle);
  vehicle.run(140);
  EXPECT_THAT(logCsv(), HasSubstr("no checkpoint is whole"));
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Active);
}

TEST_F(ResumeTest, NoFileOfAnyBytesAndNoLengthIsACrash) {
  VehicleBench vehicle({.silence_secs = 24});
  boot(vehicle);
  vehicle.run(200);
  const SparseFile whole = store_.content;
  uint64_t random = 1;
  const auto next = [&random] {
    random = random * 6364136223846793005U + 1442695040888963407U;
    return static_cast<size_t>(random >> 33U);
  };
  std::vector<double> memory(mission_.memory.size());
  for (int round = 0; round < 400; ++round) {
    RecordingStore damaged;
    damaged.content = whole;
    damaged.content.truncate(next() % 3 == 0 ? next() % whole.size() : whole.size());
    const size_t one_in = 1 + next() % 2000;
    damaged.content.eachByte([&](uint32_t, uint8_t& byte) {
      byte = next() % one_in == 0 ? static_cast<uint8_t>(next()) : byte;
    });
    GliderContext* context = layOut(memory.data(), mission_.mission);
    LinkFacts facts;
    if (Checkpoint(damaged.store(), 7).find(*context, facts) == Checkpoint::Found::Good) {
      EXPECT_LT(context->state, 2U);
      EXPECT_LE(context->stack_depth, 1U);
    }
  }
}

TEST_F(ResumeTest, ACardThatFailsIsReportedOnceAndTheMissionContinues) {
  VehicleBench vehicle({.silence_secs = 24});
  boot(vehicle);
  vehicle.run(60);
  store_.fails = true;
  vehicle.run(140);
  store_.fails = false;
  vehicle.run(200);
  store_.fails = true;
  vehicle.run(600);
  EXPECT_TRUE(finished_);
  const std::string log = logCsv(), told = "checkpoint not written";
  const size_t first = log.find(told);
  ASSERT_NE(first, std::string::npos);
  const size_t second = log.find(told, first + 1);
  ASSERT_NE(second, std::string::npos);
  EXPECT_EQ(log.find(told, second + 1), std::string::npos);
  const auto notes = std::ranges::count_if(vehicle.events, [](const hooks::SeatEvent& e) {
    return e.kind == hooks::SeatEvent::Kind::SbcNote &&
           std::string(e.text) == "the SBC's checkpoint is not written";
  });
  EXPECT_EQ(notes, 2) << "the vehicle's log has it too";
}

}  // namespace
}  // namespace glider::runtime::testing
