// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A campaign flies each flight that is not known once, and ends when it must.

#include "support/diagnostics/ids/files.h"
#include "tests/unit/campaign/small_plan.h"
#include "tests/unit/simulator/fake_sbc.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <gmock/gmock.h>

namespace glider::campaign {
namespace {

using simulator::Verdict;
using testing::deaf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::known;
using testing::smallPlan;
using ::testing::UnorderedElementsAre;

/// Records which flights are over.
CampaignListener hearing(std::vector<uint64_t>& numbers) {
  CampaignListener listener = deaf();
  listener.over = [&numbers](const CampaignFlight& flight, const Verdict&) {
    numbers.push_back(flight.number);
    return support::Result<void>();
  };
  return listener;
}

CampaignResult nothingKnown() {
  return {};
}

TEST(FlyAll, FliesEachOnceAndInTheirOrderOneAtATime) {
  std::vector<uint64_t> flown;
  const CampaignResult result = flyAll(smallPlan(3), nothingKnown(), hearing(flown));
  EXPECT_THAT(flown, ElementsAre(0, 1, 2));
  ASSERT_EQ(result.verdicts.size(), 3U);
  for (const auto& verdict : result.verdicts) {
    ASSERT_TRUE(verdict);
    EXPECT_EQ(verdict->outcome, Verdict::Outcome::Exited) << verdict->violation;
    EXPECT_GT(verdict->deepest_m, 15);
  }
  EXPECT_FALSE(result.failure || result.hung || result.interrupted || result.running);
}

TEST(FlyAll, FliesOnlyWhatIsMissing) {
  CampaignPlan plan = smallPlan(6);
  plan.jobs = 2;
  CampaignResult before;
  before.verdicts = {known(10), known(11), std::nullopt, known(13), std::nullopt, known(15)};
  std::vector<uint64_t> flown;
  CampaignListener listener = hearing(flown);
  std::vector<uint64_t> over;
  listener.progress = [&](uint64_t count) { over.push_back(count); };
  const CampaignResult result = flyAll(plan, before, listener);
  EXPECT_THAT(flown, UnorderedElementsAre(2, 4)) << "a row of the table each";
  for (const size_t number : {0U, 1U, 3U, 5U}) {
    EXPECT_EQ(result.verdicts[number]->end_s, 10 + static_cast<double>(number)) << "as it was";
  }
  EXPECT_GT(result.verdicts[2]->end_s, 500);
  EXPECT_GT(result.verdicts[4]->end_s, 500);
  ASSERT_FALSE(over.empty());
  EXPECT_GE(over.front(), 4U) << "those that are known are over";
  EXPECT_EQ(over.back(), 6U);
}

TEST(FlyAll, OfWhichAllAreKnownFliesNone) {
  CampaignResult before;
  before.verdicts = {known(1), known(2)};
  std::vector<uint64_t> flown;
  const CampaignResult result = flyAll(smallPlan(2), before, hearing(flown));
  EXPECT_TRUE(flown.empty());
  EXPECT_EQ(result.verdicts[1]->end_s, 2);
}

TEST(FlyAll, SeveralFlyAtATimeIfRequested) {
  CampaignPlan plan = smallPlan(6);
  plan.jobs = 3;
  std::atomic<int> flying = 0, most = 0;
  // Each waits until three are there, or three seconds.
  for (CampaignMission& mission : plan.missions) {
    const auto usual = mission.new_flight;
    mission.new_flight = [&, usual] {
      return [&, start = usual()] {
        ++flying;
        for (int i = 0; i < 300 && most < 3; ++i) {
          most = std::max<int>(most, flying);
          std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        --flying;
        return start();
      };
    };
  }
  std::vector<uint64_t> flown;
  flyAll(plan, nothingKnown(), hearing(flown));
  EXPECT_EQ(most, 3);
  EXPECT_THAT(flown, UnorderedElementsAre(0, 1, 2, 3, 4, 5));
}

TEST(FlyAll, ASystemErrorEndsIt) {
  CampaignPlan plan = smallPlan(10);
  plan.missions[1].new_flight = [] {
    return []() -> support::Result<std::unique_ptr<simulator::SbcPort>> {
      return support::fail(support::diagnostics::cannotRead, "the program", "gone");
    };
  };
  std::vector<uint64_t> flown;
  const CampaignResult result = flyAll(plan, nothingKnown(), hearing(flown));
  EXPECT_THAT(flown, ElementsAre(0));
  ASSERT_TRUE(result.failure);
  EXPECT_THAT(result.failure->message, HasSubstr("the program"));
  EXPECT_FALSE(result.verdicts[1]) << "it has not been flown";
}

TEST(FlyAll, ATableThatCannotBeWrittenEndsIt) {
  CampaignListener listener = deaf();
  listener.over = [](const CampaignFlight&, const Verdict&) -> support::Result<void> {
    return support::fail(support::diagnostics::cannotWrite, "the table", "full");
  };
  const CampaignResult result = flyAll(smallPlan(10), nothingKnown(), listener);
  ASSERT_TRUE(result.failure);
  EXPECT_THAT(result.failure->message, HasSubstr("the table"));
  EXPECT_EQ(std::ranges::count_if(result.verdicts, [](const auto& v) { return v.has_value(); }), 1);
}

TEST(FlyAll, WhatIsUnderWayWhenItIsEndedIsIgnored) {
  CampaignPlan plan = smallPlan(1000);
  std::vector<uint64_t> flown;
  CampaignListener listener = hearing(flown);
  std::atomic<bool> stop = false;
  listener.over = [&](const CampaignFlight& flight, const Verdict&) {
    flown.push_back(flight.number);
    stop = flight.number == 1;
    return support::Result<void>();
  };
  listener.stop = [&] { return stop.load(); };
  const CampaignResult result = flyAll(plan, nothingKnown(), listener);
  EXPECT_TRUE(result.interrupted);
  EXPECT_FALSE(result.running);
  EXPECT_THAT(flown, ElementsAre(0, 1));
  EXPECT_TRUE(result.verdicts[1]);
  EXPECT_FALSE(result.verdicts[2]);
}

TEST(FlyOne, IsTheSeedsAlone) {
  const CampaignPlan plan = smallPlan(10);
  support::Trace one, same, other;
  ASSERT_TRUE(flyOne(plan, flightOf(plan, 4), &one));
  ASSERT_TRUE(flyOne(plan, flightOf(plan, 4), &same));
  ASSERT_TRUE(flyOne(plan, flightOf(plan, 5), &other));
  EXPECT_EQ(one.seed, flightOf(plan, 4).seed);
  EXPECT_EQ(support::traceToCsv(one), support::traceToCsv(same));
  EXPECT_NE(support::traceToCsv(one), support::traceToCsv(other));
}

TEST(FlyOne, FliesTheBinaryOfItsBoard) {
  CampaignPlan plan = smallPlan(1);
  plan.boards = {"a", "b"};
  std::string started;
  for (const std::string board : {"a", "b"}) {
    plan.missions[0].on_board.push_back([&started, board, usual = plan.missions[0].new_flight] {
      started += board;
      return usual();
    });
  }
  CampaignFlight flight = flightOf(plan, 0);
  ASSERT_TRUE(flyOne(plan, flight));
  EXPECT_EQ(started, "");
  flight.board = 1;
  ASSERT_TRUE(flyOne(plan, flight));
  EXPECT_EQ(started, "b");
}

TEST(FlyOne, ItsFaultsAreInTheScenarioAndAreChecked) {
  CampaignPlan plan = smallPlan(1);
  ASSERT_TRUE(measureMissions(plan));
  plan.kinds = {simulator::FaultKind::FlightAbort};
  const auto verdict = flyOne(plan, flightOf(plan, 0));
  ASSERT_TRUE(verdict);
  EXPECT_EQ(verdict->outcome, Verdict::Outcome::Released) << verdict->violation;
  EXPECT_GT(verdict->releases, 0U);
}

TEST(FlyOne, TheFaultsOfTheScenarioAreCheckedToo) {
  CampaignPlan plan = smallPlan(1);
  plan.scenario.faults.aborts = {200};
  const auto verdict = flyOne(plan, flightOf(plan, 0));
  ASSERT_TRUE(verdict);
  EXPECT_EQ(verdict->outcome, Verdict::Outcome::Released) << verdict->violation;
}

TEST(MeasureMissions, NotesWhatIsUsualOfEach) {
  CampaignPlan plan = smallPlan(1);
  const auto later = [] {
    return support::Result<std::unique_ptr<simulator::SbcPort>>(
        std::make_unique<simulator::FakeSbc>(
            simulator::FakePilot::Plan{.bottom_m = 25, .release_s = 900}, 1e9, true));
  };
  plan.missions[1].new_flight = [later] { return later; };
  ASSERT_TRUE(measureMissions(plan));
  const auto& one = plan.missions[0];
  const auto& two = plan.missions[1];
  EXPECT_GT(one.times.take_s, 0);
  EXPECT_NEAR(one.times.release_s - one.times.take_s, 600, 20);
  EXPECT_NEAR(two.times.release_s - two.times.take_s, 900, 20);
  EXPECT_GT(one.times.flight_s, one.times.release_s);
  EXPECT_NEAR(one.times.deepest_m, 21, 2);
  EXPECT_NEAR(two.times.deepest_m, 27, 2);
  EXPECT_GT(one.mean_W, 0.1);
  EXPECT_LT(one.mean_W, 100);
}

TEST(MeasureMissions, FliesWithTheScenariosSeed) {
  CampaignPlan plan = smallPlan(1);
  plan.seed = 77;
  ASSERT_TRUE(measureMissions(plan));
  CampaignFlight flight;
  flight.seed = plan.scenario.seed;
  const auto verdict = flyOne(plan, flight);
  ASSERT_TRUE(verdict);
  EXPECT_EQ(plan.missions[0].times.deepest_m, verdict->deepest_m);
  EXPECT_EQ(plan.missions[0].times.flight_s, verdict->end_s);
}

}  // namespace
}  // namespace glider::campaign
