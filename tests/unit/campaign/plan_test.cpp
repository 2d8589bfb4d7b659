// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What a plan and a number say of a flight.

#include "campaign/campaign.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace glider::campaign {
namespace {

using simulator::FaultKind;
using simulator::Manner;

CampaignPlan planOf(size_t missions, std::vector<FaultKind> kinds = simulator::allFaultKinds()) {
  CampaignPlan plan;
  plan.missions.resize(missions);
  plan.kinds = std::move(kinds);
  return plan;
}

TEST(FlightOf, MissionsTakeTurnsThenKinds) {
  const CampaignPlan plan = planOf(3, {FaultKind::Power, FaultKind::Clock});
  for (uint64_t number = 0; number < 100; ++number) {
    const CampaignFlight flight = flightOf(plan, number);
    EXPECT_EQ(flight.number, number);
    EXPECT_EQ(flight.mission, number % 3);
    EXPECT_EQ(flight.kind, number / 3 % 2 == 0 ? FaultKind::Power : FaultKind::Clock);
    EXPECT_FALSE(flight.board);
  }
}

TEST(FlightOf, EachMissionMeetsEveryKindInEveryManner) {
  const CampaignPlan plan = planOf(2);
  std::map<size_t, std::set<std::pair<FaultKind, Manner>>> met;
  const uint64_t all = 2ULL * simulator::kFaultKinds * simulator::kManners;
  for (uint64_t number = 0; number < all; ++number) {
    const CampaignFlight flight = flightOf(plan, number);
    met[flight.mission].emplace(flight.kind, flight.manner);
  }
  EXPECT_EQ(met[0].size(), simulator::kFaultKinds * simulator::kManners);
  EXPECT_EQ(met[1], met[0]);
}

TEST(FlightOf, BeginsWithTheFirstMannerAndGoesOnByOne) {
  const CampaignPlan plan = planOf(1, {FaultKind::Power});
  EXPECT_EQ(flightOf(plan, 0).manner, Manner::Once);
  EXPECT_EQ(flightOf(planOf(1), 1).manner, Manner::Recurring);
}

TEST(RangeOf, ThePartsAreAllFlightsOnceAndInTheirOrder) {
  CampaignPlan plan = planOf(1);
  for (const uint64_t flights : {uint64_t{1}, uint64_t{7}, uint64_t{1000}, uint64_t{10'000'000}}) {
    plan.flights = flights;
    EXPECT_EQ(rangeOf(plan).begin, 0U);
    EXPECT_EQ(rangeOf(plan).end, flights) << "one part is all";
    for (const uint64_t parts : {uint64_t{3}, uint64_t{8}, uint64_t{1000}}) {
      CampaignPlan share = plan;
      share.parts = parts;
      uint64_t next = 0;
      for (share.part = 1; share.part <= parts; ++share.part) {
        const FlightRange range = rangeOf(share);
        EXPECT_EQ(range.begin, next);
        EXPECT_LE(range.end - range.begin, flights / parts + 1);
        EXPECT_GE(range.end - range.begin, flights / parts);
        next = range.end;
      }
      EXPECT_EQ(next, flights);
    }
  }
}

// A number that is reported with its seed must mean the same flight in later versions, too: the
// seeds are SplitMix64's, whose first numbers from 1234567 are published.
TEST(FlightOf, HasTheSeedsOfSplitMix64) {
  CampaignPlan plan = planOf(2);
  plan.seed = 1234567;
  EXPECT_EQ(flightOf(plan, 0).seed, 6457827717110365317U);
  EXPECT_EQ(flightOf(plan, 1).seed, 3203168211198807973U);
  EXPECT_EQ(flightOf(plan, 2).seed, 9817491932198370423U);
  EXPECT_EQ(flightOf(plan, 3).seed, 4593380528125082431U);
}

TEST(FlightOf, AShareOfThemIsOnBoards) {
  CampaignPlan plan = planOf(1);
  plan.boards = {"a", "b", "c"};
  const auto flown = [&](unsigned percent) {
    plan.board_percent = percent;
    std::vector<size_t> counts(plan.boards.size());
    for (uint64_t number = 0; number < 3000; ++number) {
      if (const auto board = flightOf(plan, number).board) {
        ++counts.at(*board);
      }
    }
    return counts;
  };
  EXPECT_EQ(flown(0), (std::vector<size_t>{0, 0, 0}));
  const auto whole = flown(100), part = flown(30);
  EXPECT_EQ(whole[0] + whole[1] + whole[2], 3000U);
  EXPECT_NEAR(static_cast<double>(part[0] + part[1] + part[2]), 900, 90);
  for (size_t board = 0; board < 3; ++board) {
    EXPECT_NEAR(static_cast<double>(whole[board]), 1000, 120) << "each its share";
    EXPECT_NEAR(static_cast<double>(part[board]), 300, 60) << "each its share";
  }
}

TEST(FlightOf, TheBoardIsNotDrawnFromWhatTheFaultsAre) {
  CampaignPlan plan = planOf(1), boards = planOf(1);
  boards.boards = {"a"};
  boards.board_percent = 50;
  for (uint64_t number = 0; number < 20; ++number) {
    EXPECT_EQ(flightOf(plan, number).seed, flightOf(boards, number).seed);
  }
  // Half of those with an even seed, too: the two are drawn apart.
  uint64_t even = 0, on_board = 0;
  for (uint64_t number = 0; number < 2000; ++number) {
    const CampaignFlight flight = flightOf(boards, number);
    even += flight.seed % 100 < 50 ? 1U : 0U;
    on_board += flight.seed % 100 < 50 && flight.board ? 1U : 0U;
  }
  EXPECT_NEAR(static_cast<double>(on_board), static_cast<double>(even) / 2,
              static_cast<double>(even) / 10);
}

TEST(FaultsOf, AreThoseOfTheFlightsKindMannerSeedAndMission) {
  CampaignPlan plan = planOf(2, {FaultKind::Power});
  plan.missions[0].times = {1000, 30, 900, 30};
  plan.missions[1].times = {50000, 30, 49000, 30};
  for (uint64_t number = 0; number < 24; ++number) {
    const CampaignFlight flight = flightOf(plan, number);
    const auto expected = simulator::drawFaults(FaultKind::Power, flight.manner, flight.seed,
                                                plan.missions[number % 2].times);
    const auto drawn = faultsOf(plan, flight);
    ASSERT_EQ(drawn.faults.power.size(), expected.faults.power.size());
    for (size_t i = 0; i < drawn.faults.power.size(); ++i) {
      EXPECT_EQ(drawn.faults.power[i].from_s, expected.faults.power[i].from_s);
      EXPECT_EQ(drawn.faults.power[i].to_s, expected.faults.power[i].to_s);
    }
  }
}

}  // namespace
}  // namespace glider::campaign
