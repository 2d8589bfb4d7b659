// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A campaign on several ranks, which here are threads: what rank 0 and the others tell each other.

#include "support/diagnostics/ids/files.h"
#include "support/diagnostics/ids/flights.h"
#include "tests/unit/campaign/joined_ranks.h"
#include "tests/unit/campaign/small_plan.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <gmock/gmock.h>
#include <thread>

namespace glider::campaign {
namespace {

using simulator::Verdict;
using std::chrono::milliseconds;
using testing::deaf;
using ::testing::HasSubstr;
using testing::JoinedRanks;
using testing::Post;
using testing::smallPlan;

/// The other ranks, each of which flies a plan of its own.
class Others {
 public:
  explicit Others(size_t size) : post_(std::make_shared<Post>(size)), zero(post_, 0) {}
  ~Others() {
    for (std::thread& thread : threads_) {
      thread.join();
    }
  }
  void start(size_t rank, CampaignPlan plan, std::function<bool()> stop = [] { return false; }) {
    threads_.emplace_back([post = post_, rank, plan = std::move(plan), stop = std::move(stop)] {
      JoinedRanks ranks(post, rank);
      serveRank(plan, ranks, stop);
    });
  }

 private:
  std::shared_ptr<Post> post_;
  std::vector<std::thread> threads_;

 public:
  JoinedRanks zero;
};

/// No flight of `plan` begins before `gate` is open; each is counted.
void holdBack(CampaignPlan& plan, std::atomic<bool>& gate, std::atomic<int>& begun) {
  for (CampaignMission& mission : plan.missions) {
    mission.new_flight = [&gate, &begun, usual = mission.new_flight] {
      return [&gate, &begun, start = usual()] {
        ++begun;
        for (int i = 0; i < 2000 && !gate; ++i) {
          std::this_thread::sleep_for(milliseconds(5));
        }
        return start();
      };
    };
  }
}

TEST(FlyAllOnRanks, GivesTheSameVerdictsAsOneProcess) {
  CampaignPlan plan = smallPlan(12);
  plan.kinds = simulator::allFaultKinds();
  ASSERT_TRUE(measureMissions(plan));
  const std::string alone = campaignCsv(plan, flyAll(plan, {}, deaf()), "id");
  for (const size_t size : {2U, 3U, 20U}) {
    Others others(size);
    for (size_t rank = 1; rank < size; ++rank) {
      others.start(rank, plan);
    }
    const CampaignResult result = flyAll(plan, {}, deaf(), &others.zero);
    EXPECT_FALSE(result.failure || result.hung || result.interrupted || result.left_ranks);
    EXPECT_EQ(campaignCsv(plan, result, "id"), alone) << size << " ranks";
  }
}

TEST(FlyAllOnRanks, AllOfThemFly) {
  std::atomic<bool> gate = false;
  std::atomic<int> here = 0, there = 0;
  CampaignPlan mine = smallPlan(8), theirs = mine;
  holdBack(mine, gate, here);
  holdBack(theirs, gate, there);
  Others others(3);
  others.start(1, theirs);
  others.start(2, theirs);
  std::thread opener([&] {
    for (int i = 0; i < 2000 && (here < 1 || there < 2); ++i) {
      std::this_thread::sleep_for(milliseconds(5));
    }
    EXPECT_EQ(here, 1);
    EXPECT_EQ(there, 2);
    gate = true;
  });
  std::vector<uint64_t> over;
  CampaignListener listener = deaf();
  listener.over = [&](const CampaignFlight& flight, const Verdict&) {
    over.push_back(flight.number);
    return support::Result<void>();
  };
  flyAll(mine, {}, listener, &others.zero);
  opener.join();
  EXPECT_THAT(over, ::testing::UnorderedElementsAre(0, 1, 2, 3, 4, 5, 6, 7)) << "each once";
}

TEST(FlyAllOnRanks, ASystemErrorOfAnotherEndsIt) {
  std::atomic<bool> gate = false;
  std::atomic<int> begun = 0;
  CampaignPlan mine = smallPlan(1000), theirs = mine;
  theirs.missions[0].new_flight = theirs.missions[1].new_flight = [&] {
    return [&]() -> support::Result<std::unique_ptr<simulator::SbcPort>> {
      gate = true;
      return support::fail(support::diagnostics::cannotRead, "the program", "gone");
    };
  };
  holdBack(mine, gate, begun);
  Others others(2);
  others.start(1, theirs);
  const CampaignResult result = flyAll(mine, {}, deaf(), &others.zero);
  ASSERT_TRUE(result.failure);
  EXPECT_EQ(result.failure->id, support::diagnostics::cannotRead);
  EXPECT_THAT(result.failure->message, HasSubstr("(rank 1): cannot read `the program`: gone"));
  EXPECT_FALSE(result.left_ranks);
}

TEST(FlyAllOnRanks, ASignalToAnotherEndsIt) {
  std::atomic<bool> gate = false;
  std::atomic<int> begun = 0;
  CampaignPlan mine = smallPlan(1000);
  holdBack(mine, gate, begun);
  Others others(2);
  others.start(1, smallPlan(1000), [&] { return begun > 0 && (gate = true); });
  const CampaignResult result = flyAll(mine, {}, deaf(), &others.zero);
  EXPECT_TRUE(result.interrupted);
  EXPECT_FALSE(result.left_ranks);
}

TEST(FlyAllOnRanks, AHangOfAnotherIsAViolationThatEndsIt) {
  const auto let_go = std::make_shared<std::atomic<bool>>(false);
  CampaignPlan mine = smallPlan(1000), theirs = mine;
  theirs.hang_s = 0.3;
  for (CampaignMission& mission : theirs.missions) {
    mission.new_flight = [let_go] {
      return [let_go]() -> support::Result<std::unique_ptr<simulator::SbcPort>> {
        while (!*let_go) {
          std::this_thread::sleep_for(milliseconds(5));
        }
        return support::fail(support::diagnostics::cannotRead, "it", "gone");
      };
    };
  }
  CampaignResult result;
  {
    Others others(2);
    others.start(1, std::move(theirs));
    result = flyAll(mine, {}, deaf(), &others.zero);
  }
  EXPECT_TRUE(result.hung);
  EXPECT_FALSE(result.failure || result.left_ranks || result.running);
  int hangs = 0, flown = 0;
  for (const auto& verdict : result.verdicts) {
    hangs += verdict && verdict->violation == "the flight hangs" ? 1 : 0;
    flown += verdict ? 1 : 0;
  }
  EXPECT_EQ(hangs, 1);
  EXPECT_LT(flown, 1000) << "the rest is left";
  *let_go = true;
  for (int i = 0; i < 1000 && let_go.use_count() > 1; ++i) {
    std::this_thread::sleep_for(milliseconds(10));
  }
}

TEST(FlyAllOnRanks, OneThatDoesNotAnswerIsReported) {
  Others others(2);  // no one serves rank 1
  CampaignListener listener = deaf();
  std::atomic<bool> stop = false;
  listener.over = [&](const CampaignFlight&, const Verdict&) {
    stop = true;
    return support::Result<void>();
  };
  listener.stop = [&] { return stop.load(); };
  const CampaignResult result = flyAll(smallPlan(10), {}, listener, &others.zero);
  EXPECT_TRUE(result.interrupted);
  EXPECT_TRUE(result.left_ranks);
}

TEST(DismissRanks, WaitsForEachToSayBye) {
  Others others(3);
  others.start(1, smallPlan(1));
  others.start(2, smallPlan(1));
  EXPECT_TRUE(dismissRanks(others.zero));
}

class ReadinessOfRanks : public ::testing::Test {
 protected:
  /// What rank 0 makes of a rank that flies `plan`.
  support::Result<void> compared(const CampaignPlan& plan, const std::string& identity = "id") {
    const auto post = std::make_shared<Post>(2);
    JoinedRanks zero(post, 0), one(post, 1);
    sendReadiness(one, readinessOf(plan, identity));
    const auto others = awaitReadiness(zero);
    EXPECT_EQ(others.size(), 1U);
    EXPECT_EQ(others.at(0).status, 0);
    return requireSame(readinessOf(own_, "id"), others);
  }
  static void refused(const support::Result<void>& result, const std::string& why) {
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().id, support::diagnostics::rankDiffers);  // refused: GL9389
    EXPECT_THAT(result.error().message, HasSubstr("rank 1 on `"));
    EXPECT_THAT(result.error().message, HasSubstr(why));
  }
  CampaignPlan own_ = smallPlan(1);
};

TEST_F(ReadinessOfRanks, TheSameCampaignIsAccepted) {  // accepts: GL9389
  EXPECT_TRUE(compared(own_));
}

TEST_F(ReadinessOfRanks, AnotherCampaignIsRefused) {
  refused(compared(own_, "another"), "its glidercc, files or options");
  CampaignPlan plan = own_;
  plan.boards = {"a", "b"};
  refused(compared(plan), "emulators of the boards `a, b`, not of ``");
}

TEST_F(ReadinessOfRanks, AProcessorThatRoundsDifferentlyIsRefused) {
  for (const auto& change : std::vector<std::function<void(CampaignMission&)>>{
           [](CampaignMission& one) { one.mean_W = std::nextafter(one.mean_W, 100); },
           [](CampaignMission& one) { one.times.deepest_m += 1e-12; },
           [](CampaignMission& one) { one.times.hover.to_s += 4; },
           [](CampaignMission& one) { one.times.release_s += 4; }}) {
    CampaignPlan plan = own_;
    change(plan.missions[1]);
    refused(compared(plan), "rounds differently");
  }
}

TEST_F(ReadinessOfRanks, OneThatCannotFlySaysWhy) {
  const auto post = std::make_shared<Post>(2);
  JoinedRanks zero(post, 0), one(post, 1);
  sendReadiness(one, unreadiness(1, "two\nlines\n"));
  const auto others = awaitReadiness(zero);
  ASSERT_EQ(others.size(), 1U);
  EXPECT_EQ(others[0].rank, 1U);
  EXPECT_EQ(others[0].status, 1);
  EXPECT_EQ(others[0].reported, "two\nlines\n");
  EXPECT_NE(others[0].host, "");
}

}  // namespace
}  // namespace glider::campaign
