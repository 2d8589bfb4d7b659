// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The checks of flights of a vehicle that is steered by its port.

#include "vehicles/slocum/oracles/port_judge.h"

#include "tests/unit/slocum/good_flight.h"

#include <gtest/gtest.h>

#include <string_view>

namespace glider::slocum::oracles {
namespace {

using simulator::JudgeId;
using simulator::Verdict;

/// A vehicle of which each cycle is given.
class PortJudged : public testing::Test {
 protected:
  bool cycle(double depth_m, double clearance_m = 50, bool aborted = false) {
    now_ += 4;
    return judge_.cycle(
        {now_, HookState::Absent, depth_m, aborted, false, array_, now_, clearance_m});
  }
  void write(std::string_view sentence) {
    judge_.said({reinterpret_cast<const uint8_t*>(sentence.data()), sentence.size()}, now_);
  }
  /// The checks that found something, in order.
  std::vector<JudgeId> found() const {
    std::vector<JudgeId> all;
    for (const simulator::Violation& one : judge_.verdict().violations) {
      all.push_back(one.judge);
    }
    return all;
  }
  PortPromise promise_{.deepest_m = 45, .under_s = 1000, .may_abort = false, .sees_bottom = true};
  PortJudge judge_{promise_};
  SensorArray array_{shippedSetup("default").platform};
  double now_ = 0;
};

TEST_F(PortJudged, AFlightWithinItsBoundsIsFine) {
  for (int i = 0; i < 200; ++i) {
    EXPECT_TRUE(cycle(44.9, 0.5));
  }
  EXPECT_TRUE(cycle(0.5, 0));
  EXPECT_TRUE(found().empty()) << "at the surface there is no bottom to touch";
  EXPECT_EQ(judge_.verdict().outcome, Verdict::Outcome::Released);
  EXPECT_EQ(judge_.verdict().deepest_m, 44.9);
}

TEST_F(PortJudged, ADepthBeyondTheBoundIsSeen) {
  cycle(45.1);
  cycle(60);
  EXPECT_EQ(found(), std::vector{JudgeId::Depth});
  EXPECT_EQ(judge_.verdict().outcome, Verdict::Outcome::Violation);
  EXPECT_EQ(judge_.verdict().violation, "45.1 m deep, at most 45.0 m");
}

TEST_F(PortJudged, SoIsTheBottomWhereTheAltimeterWorks) {
  cycle(20, 0.05);
  EXPECT_EQ(found(), std::vector{JudgeId::Bottom});
  promise_.sees_bottom = false;
  judge_ = PortJudge(promise_);
  cycle(20, 0.05);
  EXPECT_TRUE(found().empty());
}

TEST_F(PortJudged, SoIsAVehicleThatDoesNotComeUp) {
  for (int i = 0; i < 252; ++i) {
    cycle(10);
  }
  EXPECT_EQ(found(), std::vector{JudgeId::Surface});
  EXPECT_EQ(judge_.verdict().violation_s, 1008);
}

TEST_F(PortJudged, SoIsAnAbortThatNoFaultCauses) {
  cycle(10, 50, true);
  EXPECT_EQ(found(), std::vector{JudgeId::Ending});
  promise_.may_abort = true;
  judge_ = PortJudge(promise_);
  cycle(10, 50, true);
  EXPECT_TRUE(found().empty());
}

TEST_F(PortJudged, WhatTheSbcWritesSaysWhenItsMissionFliesAndEnds) {
  cycle(0);
  write("$SW,3:20.000000,8:1.000000*6c\r\n");
  EXPECT_EQ(judge_.verdict().take_s, 0) << "another sum";
  const auto sentence = [](std::string body) {
    uint8_t sum = 0;
    for (const char c : body) {
      sum ^= static_cast<uint8_t>(c);
    }
    return fmt::format("${}*{:02x}\r\n", body, sum);
  };
  write(sentence("SW,3:20,8:1,9:1"));
  cycle(10);
  write(sentence("SW,3:20,8:2,9:2"));
  write(sentence("SW,3:30,8:2,9:3"));
  EXPECT_EQ(judge_.verdict().take_s, 4);
  EXPECT_EQ(judge_.verdict().instructions, 2U);
  EXPECT_EQ(judge_.verdict().outcome, Verdict::Outcome::Released);
  cycle(0);
  write(sentence("SW,7:2,8:0,9:4"));
  EXPECT_EQ(judge_.verdict().outcome, Verdict::Outcome::Exited);
  EXPECT_EQ(judge_.verdict().release_s, 12);
  int cycles = 0;
  while (cycle(0) && cycles < 1000) {
    ++cycles;
  }
  EXPECT_LT(cycles, 100) << "the flight is over";
}

}  // namespace
}  // namespace glider::slocum::oracles
