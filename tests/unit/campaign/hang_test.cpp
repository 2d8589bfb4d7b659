// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A flight that does not come back.

#include "support/diagnostics/ids/files.h"
#include "tests/unit/campaign/small_plan.h"
#include "tests/unit/simulator/fake_sbc.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <gmock/gmock.h>
#include <mutex>
#include <thread>

namespace glider::campaign {
namespace {

using simulator::Verdict;
using std::chrono::milliseconds;
using ::testing::ElementsAre;

/// What outlives the test as long as a flight of it does.
struct Shared {
  std::atomic<bool> let_go = false;
  std::atomic<bool> comes_back = false;  ///< once it has been reported that it hangs
  std::mutex mutex;
  std::vector<std::string> over;  ///< of flight 1: what was reported about it
};

/// A campaign of four flights, of which 0 and 2 are known. The SBC of 1 and 3 does not start.
class Hang : public ::testing::Test {
 protected:
  Hang() : plan_(testing::smallPlan(4)) {
    known_.verdicts = {testing::known(0), std::nullopt, testing::known(2), std::nullopt};
    plan_.hang_s = 0.3;
    plan_.scenario.duration_s = 20;
    plan_.missions[1].new_flight = [shared = shared_, usual = plan_.missions[1].new_flight] {
      return [shared, start = usual()]() -> support::Result<std::unique_ptr<simulator::SbcPort>> {
        while (!shared->let_go) {
          std::this_thread::sleep_for(milliseconds(5));
        }
        return shared->comes_back ? start()
                                  : support::fail(support::diagnostics::cannotRead, "it", "gone");
      };
    };
  }
  ~Hang() override {
    shared_->let_go = true;
    plan_ = {};
    for (int i = 0; i < 1000 && shared_.use_count() > 1; ++i) {
      std::this_thread::sleep_for(milliseconds(10));
    }
  }

  CampaignResult fly() {
    CampaignListener listener = testing::deaf();
    listener.over = [shared = shared_](const CampaignFlight& flight, const Verdict& verdict) {
      const std::scoped_lock lock(shared->mutex);
      if (flight.number == 1) {
        shared->over.push_back(verdict.violation);
        shared->let_go = shared->comes_back.load();
      }
      return support::Result<void>();
    };
    return flyAll(plan_, known_, listener);
  }
  [[nodiscard]] std::vector<std::string> told() const {
    const std::scoped_lock lock(shared_->mutex);
    return shared_->over;
  }

  const std::shared_ptr<Shared> shared_ = std::make_shared<Shared>();
  CampaignPlan plan_;
  CampaignResult known_;
};

TEST_F(Hang, IsAViolationThatEndsTheCampaign) {
  const CampaignResult result = fly();
  EXPECT_TRUE(result.hung);
  EXPECT_TRUE(result.running) << "its thread cannot be ended";
  ASSERT_TRUE(result.verdicts[1]);
  EXPECT_EQ(result.verdicts[1]->outcome, Verdict::Outcome::Violation);
  EXPECT_THAT(told(), ElementsAre("the flight hangs"));
  EXPECT_FALSE(result.verdicts[3]) << "the rest is left";
}

// The campaign waits a second for the flights that are under way.
TEST_F(Hang, ThatEndsAfterAllIsReportedOnce) {
  shared_->comes_back = true;
  const CampaignResult result = fly();
  EXPECT_TRUE(result.hung);
  EXPECT_FALSE(result.running);
  EXPECT_THAT(told(), ElementsAre("the flight hangs")) << "one row of the table";
  EXPECT_EQ(result.verdicts[1]->violation, "the flight hangs");
  EXPECT_FALSE(result.verdicts[3]) << "the rest is left";
}

TEST_F(Hang, BehindAnEmulatorTakesLonger) {
  shared_->comes_back = true;
  plan_.boards = {"a"};
  plan_.board_percent = 100;
  plan_.hang_on_board_s = 60;
  plan_.missions[1].on_board = {plan_.missions[1].new_flight};
  std::thread later([shared = shared_] {
    std::this_thread::sleep_for(milliseconds(900));
    shared->let_go = true;
  });
  const CampaignResult result = fly();
  later.join();
  EXPECT_FALSE(result.hung);
  EXPECT_EQ(told().size(), 1U);
  EXPECT_TRUE(result.verdicts[3]);
}

/// On a slow machine, or of a mission of days.
TEST(HangOfAPlan, IsLaterWhereAFlightTakesLong) {
  CampaignPlan plan = testing::smallPlan(4);
  plan.scenario.duration_s = 20;
  plan.missions[0].new_flight = [usual = plan.missions[0].new_flight] {
    return [start = usual()]() -> support::Result<std::unique_ptr<simulator::SbcPort>> {
      std::this_thread::sleep_for(milliseconds(1100));
      return start();
    };
  };
  ASSERT_TRUE(measureMissions(plan));
  EXPECT_GE(plan.hang_s, 66);
  EXPECT_GE(plan.hang_on_board_s, 1320);
}

TEST(HangOfAPlan, IsAMinuteOrTenBehindAnEmulator) {
  EXPECT_EQ(CampaignPlan().hang_s, 60);
  EXPECT_EQ(CampaignPlan().hang_on_board_s, 600);
}

}  // namespace
}  // namespace glider::campaign
