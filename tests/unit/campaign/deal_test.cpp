// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// How flights are dealt to workers: each once, and so that all workers end at about the same time.

#include "campaign/workers/deal.h"

#include "tests/unit/campaign/small_plan.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <random>
#include <set>

namespace glider::campaign {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using Numbers = std::vector<uint64_t>;

CampaignPlan dealt(uint64_t flights, unsigned jobs = 1) {
  CampaignPlan plan;
  plan.flights = flights;
  plan.jobs = jobs;
  return plan;
}

CampaignResult nothing(uint64_t flights) {
  CampaignResult known;
  known.verdicts.resize(flights);
  return known;
}

TEST(Deal, GivesWhatIsNotKnownInOrder) {
  CampaignResult known = nothing(6);
  known.verdicts[1] = known.verdicts[4] = testing::known(1);
  Deal deal(dealt(6), known, 1);
  EXPECT_THAT(deal.next(0), ElementsAre(0, 2)) << "one to fly and one to go on with";
  EXPECT_THAT(deal.next(0), IsEmpty());
  deal.isOver(0);
  EXPECT_THAT(deal.next(0), ElementsAre(3));
  deal.isOver(0);
  EXPECT_THAT(deal.next(0), ElementsAre(5));
  deal.isOver(0);
  EXPECT_FALSE(deal.isDone()) << "flight 5 is under way";
  deal.isOver(0);
  EXPECT_TRUE(deal.isDone());
  EXPECT_THAT(deal.next(0), IsEmpty());
}

TEST(Deal, OfWhichAllAreKnownIsDone) {
  EXPECT_TRUE(Deal(dealt(0), nothing(0), 2).isDone());
}

TEST(Deal, IsOfThePartOfThePlan) {
  CampaignPlan plan = dealt(10);
  plan.part = 2;
  plan.parts = 3;
  Deal deal(plan, nothing(10), 1);
  std::set<uint64_t> numbers;
  while (!deal.isDone()) {
    for (const uint64_t number : deal.next(0)) {
      numbers.insert(number);
    }
    deal.isOver(0);
  }
  EXPECT_THAT(numbers, ElementsAre(3, 4, 5));
}

TEST(Deal, GivesManyWhileManyAreLeftAndFewAtTheEnd) {
  Deal deal(dealt(10000, 2), nothing(10000), 4);
  EXPECT_THAT(deal.next(0), SizeIs(2 * 17)) << "a message for each flight would be many";
  EXPECT_THAT(deal.next(0), IsEmpty());
  deal.isOver(0);
  EXPECT_THAT(deal.next(0), IsEmpty()) << "it still has enough";
  Deal few(dealt(9, 2), nothing(9), 4);
  EXPECT_THAT(few.next(0), SizeIs(4));
  EXPECT_THAT(few.next(1), SizeIs(4));
  EXPECT_THAT(few.next(2), ElementsAre(8));
  EXPECT_THAT(few.next(3), IsEmpty());
}

// Workers of different speed, and the flights of each of different lengths.
TEST(Deal, GivesEachFlightOnceAndLetsNoWorkerWait) {
  constexpr uint64_t kFlights = 3000;
  constexpr size_t kWorkers = 5;
  Deal deal(dealt(kFlights), nothing(kFlights), kWorkers);
  std::mt19937 random(7);
  std::vector<Numbers> waiting(kWorkers);
  std::vector<int> busy(kWorkers), idle(kWorkers);
  std::vector<bool> flies(kWorkers);
  std::multiset<uint64_t> flown;
  for (int step = 0; !deal.isDone(); ++step) {
    ASSERT_LT(step, 1000000);
    for (size_t worker = 0; worker < kWorkers; ++worker) {
      for (const uint64_t number : deal.next(worker)) {
        waiting[worker].push_back(number);
      }
      if (flies[worker] && --busy[worker] == 0) {
        flies[worker] = false;
        deal.isOver(worker);
      }
      if (!flies[worker] && !waiting[worker].empty()) {
        flies[worker] = true;
        busy[worker] = 1 + static_cast<int>(random() % (10 * (worker + 1)));
        flown.insert(waiting[worker].front());
        waiting[worker].erase(waiting[worker].begin());
      }
      idle[worker] += flies[worker] ? 0 : 1;
    }
  }
  EXPECT_EQ(flown.size(), kFlights);
  EXPECT_EQ(std::set<uint64_t>(flown.begin(), flown.end()).size(), kFlights);
  for (const int steps : idle) {
    EXPECT_LT(steps, 150) << "two of the longest flights, and what is left of one";
  }
}

}  // namespace
}  // namespace glider::campaign
