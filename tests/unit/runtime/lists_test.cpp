// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The four lists of a tick: what is tried, in which order, and what `always` may interrupt.

#include "tests/unit/runtime/bench_mission.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace glider::runtime::testing {
namespace {

constexpr double kNoElement = std::numeric_limits<double>::quiet_NaN();

/// States a, b, c, d; `always` calls c (0), goes to d (1), stays (2). `on` holds the cases of
/// `always` whose guards are true, `fire` the state's own.
class ListsTest : public ::testing::Test {
 protected:
  ListsTest() {
    for (const char* name : {"a", "b", "c", "d"}) {
      bench_.states.push_back(benchState(name, cases_, 6));
    }
    bench_.always = {{kGliderCall, 2}, {kGliderGoto, 3}, {kGliderStay, 0}};
    bench_.guards = [this](const GliderContext&) {
      story_ += "S";
      return fire;
    };
    bench_.always_guards = [this](const GliderContext&, uint32_t from) {
      story_ += "A" + std::to_string(from);
      for (uint32_t i = from; i < 3; ++i) {
        if ((on >> i & 1U) != 0) {
          return i;
        }
      }
      return GLIDER_NO_CASE;
    };
    bench_.act = [this](GliderContext& c, uint32_t list, uint32_t fired) {
      story_ += "d" + std::to_string(list) + std::to_string(fired) + "@" + std::to_string(c.state);
    };
    bench_.fly = [this](GliderContext&, uint32_t phase) {
      story_ += phase == kGliderTick ? "P" : phase == kGliderEnter ? "E" : "R";
    };
    bench_.route = [this](GliderContext&) {
      story_ += "r";
      return 7U;
    };
    bench_.advance = [this](GliderContext&) { story_ += "t"; };
    bench_.finish(3);
    c_ = bench_.start();
  }
  /// What a tick does.
  std::string tick() {
    story_.clear();
    step(c_, c_->mission_time + 4);
    return story_;
  }
  enum : uint32_t { ToB, CallB, Back, Stay, CallD, Leave };
  static constexpr uint32_t None = GLIDER_NO_CASE;
  GliderCaseInfo cases_[6] = {{kGliderGoto, 1}, {kGliderCall, 1}, {kGliderReturn, 0},
                              {kGliderStay, 0}, {kGliderCall, 3}, {kGliderExit, 0}};
  uint32_t fire = None;
  uint32_t on = 0;
  std::string story_;
  BenchMission bench_;
  GliderContext* c_ = nullptr;
};

TEST_F(ListsTest, AreTriedInTurn) {
  EXPECT_EQ(tick(), "tA0SPr");
  EXPECT_EQ(c_->fired_route, 7U);
  EXPECT_EQ(c_->moved_list, GLIDER_NO_LIST);
}

TEST_F(ListsTest, StayGoesOnToTheNextList) {
  on = 4;
  fire = Stay;
  EXPECT_EQ(tick(), "tA0d02@0Sd13@0Pr");
  EXPECT_EQ(c_->fired_always, 2U);
  EXPECT_EQ(c_->fired_state, static_cast<uint32_t>(Stay));
  EXPECT_EQ(c_->moved_list, GLIDER_NO_LIST);
  on = 0;
  fire = None;
  tick();
  EXPECT_EQ(c_->fired_always, GLIDER_NO_CASE) << "of the tick that it is";
}

TEST_F(ListsTest, ATransitionEndsTheTickAndActsInTheOldState) {
  on = 1;
  fire = ToB;
  EXPECT_EQ(tick(), "tA0d00@0E");
  EXPECT_EQ(c_->state, 2U);
  EXPECT_EQ(c_->moved_list, static_cast<uint32_t>(kGliderListAlways));
  EXPECT_EQ(c_->moved_case, 0U);
  EXPECT_EQ(c_->limit, 0U);
  EXPECT_EQ(c_->fired_state, GLIDER_NO_CASE);
}

TEST_F(ListsTest, AfterAReturnTheCallersOwnCasesComeFirst) {
  on = 1;
  tick();
  on = 0;
  fire = Back;
  EXPECT_EQ(tick(), "tSd12@2R") << "no case of always stands before number 0";
  EXPECT_EQ(c_->state, 0U);
  EXPECT_EQ(c_->limit, GLIDER_NO_LIMIT);
  fire = None;
  EXPECT_EQ(tick(), "tSA0Pr");
  EXPECT_EQ(tick(), "tA0SPr") << "once";
  on = 1;
  tick();
  fire = Back;
  on = 0;
  tick();
  on = 1;
  fire = ToB;
  EXPECT_EQ(tick(), "tSd10@0E") << "what repeats starves nothing";
  EXPECT_EQ(c_->state, 1U);
}

TEST_F(ListsTest, ACaseWhoseTargetIsInUseFallsThrough) {
  fire = CallB;
  tick();
  fire = None;
  on = 1;
  tick();
  EXPECT_EQ(c_->state, 2U);
  EXPECT_EQ(c_->stack_depth, 2U);
  fire = CallD;
  on = 0;
  tick();
  EXPECT_EQ(c_->state, 3U);
  EXPECT_EQ(c_->frames[2].limit, 0U) << "call by a state's own case leaves the limit";
  EXPECT_EQ(c_->limit, 0U);
  fire = None;
  on = 7;
  EXPECT_EQ(tick(), "tSPr") << "nothing stands before case 0";
}

TEST_F(ListsTest, TheCurrentStateIsInUseToo) {
  on = 2;
  tick();
  EXPECT_EQ(c_->state, 3U);
  EXPECT_EQ(c_->limit, 1U);
  on = 7;
  EXPECT_EQ(tick(), "tA0d00@3E") << "case 0 stands before the limit";
  EXPECT_EQ(c_->state, 2U);
  EXPECT_EQ(c_->frames[0].limit, 1U);
  fire = Back;
  tick();
  EXPECT_EQ(c_->state, 3U);
  EXPECT_EQ(c_->limit, 1U);
  fire = None;
  on = 2;
  EXPECT_EQ(tick(), "tSA0Pr") << "case 1 is the limit: it may not fire itself";
  fire = ToB;
  on = 0;
  tick();
  EXPECT_EQ(c_->limit, GLIDER_NO_LIMIT) << "goto by a state's own case";
  fire = None;
  on = 6;
  tick();
  EXPECT_EQ(c_->state, 3U);
}

TEST_F(ListsTest, AfterExitNothingFires) {
  fire = Leave;
  EXPECT_EQ(tick(), "tA0Sd15@0");
  EXPECT_EQ(c_->finished, 1U);
  EXPECT_EQ(c_->moved_list, static_cast<uint32_t>(kGliderListState));
  EXPECT_EQ(tick(), "");
  EXPECT_EQ(c_->fired_state, GLIDER_NO_CASE);
  EXPECT_EQ(c_->moved_list, GLIDER_NO_LIST);
}

TEST_F(ListsTest, AGuardAfterOneThatMayNotFireIsStillTried) {
  on = 1;
  tick();
  EXPECT_EQ(c_->state, 2U);
  fire = ToB;
  on = 0;
  tick();
  cases_[CallB].target = 2;  // c again, by a state's own case: the limit is endless
  fire = CallB;
  tick();
  fire = None;
  on = 5;
  EXPECT_EQ(tick(), "tA0A1d02@2SPr");
}

TEST(Notes, AreOfTheirTickAndBounded) {
  BenchMission bench;
  bench.states = {benchState("a")};
  uint32_t notes = 20;
  uint32_t values = 3;
  bench.advance = [&](GliderContext& c) {
    const double numbers[100] = {1, 2, 3};
    for (uint32_t i = 0; i < notes; ++i) {
      gliderNote(&c, kGliderNoteLog, "depth", numbers, values);
    }
  };
  bench.finish(0);
  GliderContext* c = bench.start();
  step(c, 4);
  EXPECT_EQ(c->note_count, GLIDER_MOST_NOTES);
  EXPECT_EQ(c->note_value_count, 48U);
  EXPECT_EQ(c->lost_notes, 4U);
  EXPECT_EQ(c->notes[15].first, 45U);
  EXPECT_EQ(c->note_values[47], 3);
  notes = 2;
  values = 40;
  step(c, 8);
  EXPECT_EQ(c->note_count, 2U);
  EXPECT_EQ(c->notes[1].count, 24U) << "what there is room for";
  EXPECT_EQ(c->lost_notes, 1U);
  notes = 0;
  step(c, 12);
  EXPECT_EQ(c->note_count, 0U);
  EXPECT_EQ(c->lost_notes, 0U);
}

TEST(Start, GivesParametersTheirValuesAndLeavesTheRestUnknown) {
  BenchMission bench;
  bench.states = {benchState("a")};
  bench.parameters = {{"bottom", 25, 10, 30, "m=3ff0000000000000"},
                      {"top", 5, 1, 9, "m=3ff0000000000000"}};
  bench.variable_count = 2;
  bench.begin = [](GliderContext& c) { c.variables[2] = c.variables[0] + c.variables[1]; };
  bench.finish(0);
  const GliderContext* c = bench.start();
  EXPECT_EQ(c->variables[0], 25);
  EXPECT_EQ(c->variables[2], 30);
  EXPECT_TRUE(std::isnan(c->variables[3]));
  const double values[] = {20, kNoElement};
  c = bench.start({}, values);
  EXPECT_EQ(c->variables[0], 20);
}

}  // namespace
}  // namespace glider::runtime::testing
