// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What was recorded earlier and arrives again: hookbeh refuses it, and reports that.

#include "hooks/hookbeh/hookbeh.h"
#include "hooks/protocol/messages.h"
#include "tests/slocum.h"
#include "tests/unit/hooks/hookbeh_bench.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace glider::hooks {
namespace {

/// A bench whose instructions can be written again as they were.
class HookbehReplay : public testing::Test {
 protected:
  using Bench = HookbehBench;

  HookbehReplay() { bench_.cycle(); }

  HookbehOutputs give(const Instruction& instruction) {
    const HookbehOutputs out = bench_.give(instruction);
    recorded_.push_back(bench_.inputs);
    return out;
  }

  /// The instruction given as number `index`, from 0, once more.
  HookbehOutputs again(size_t index) {
    const HookbehInputs now = bench_.inputs;
    bench_.inputs = recorded_.at(index);
    bench_.inputs.time_s = now.time_s;
    bench_.inputs.depth_m = now.depth_m;
    return bench_.cycle();
  }

  Bench bench_;
  std::vector<HookbehInputs> recorded_;
};

TEST_F(HookbehReplay, AnInstructionOfTheSessionThatComesAgainIsRefusedAndAnswered) {
  give(Bench::take(20));
  give(Bench::ascend(5));
  give(Bench::descend(25));
  for (const size_t old : {0U, 1U}) {
    const HookbehOutputs out = again(old);
    EXPECT_EQ(out.answer, HookAnswer::OldSequence);
    EXPECT_EQ(out.answered_sequence, old + 1) << "under its own number";
    EXPECT_EQ(out.state, HookState::Active);
    EXPECT_STREQ(wordsFor(out.doing), "dive_to");
    EXPECT_EQ(out.session, 1U);
  }
  const HookbehOutputs newest = again(2);
  EXPECT_EQ(newest.answer, HookAnswer::Accepted) << "the newest keeps its answer";
  EXPECT_EQ(newest.answered_sequence, 3);
  EXPECT_EQ(give(Bench::ascend(5)).answer, HookAnswer::Accepted) << "and the next is obeyed";
}

TEST_F(HookbehReplay, ARefusedInstructionKeepsItsOwnReason) {
  give(Bench::take(20));
  give(Bench::descend(99));
  EXPECT_EQ(again(0).answer, HookAnswer::OldSequence);
  const HookbehOutputs out = again(1);
  EXPECT_EQ(out.answer, HookAnswer::TooDeep);
  EXPECT_EQ(out.answered_sequence, 2);
}

TEST_F(HookbehReplay, AnOldReleaseEndsNothing) {
  give(Bench::take(20));
  bench_.write(Bench::giveBack());
  const HookbehInputs never_arrived = bench_.inputs;
  bench_.inputs = recorded_.at(0);
  bench_.cycle();
  give(Bench::descend(25));
  recorded_.push_back(never_arrived);
  const HookbehOutputs out = again(2);
  EXPECT_EQ(out.state, HookState::Active);
  EXPECT_EQ(out.answer, HookAnswer::OldSequence);
}

TEST_F(HookbehReplay, AnOldTakeOfAnEarlierSessionTakesNothing) {
  give(Bench::take(20, 1));
  bench_.alive = false;
  for (int i = 0; i < 6; ++i) {
    bench_.cycle();
  }
  bench_.alive = true;
  ASSERT_EQ(give(Bench::take(99, 2)).answer, HookAnswer::TooDeep) << "never in control";
  EXPECT_EQ(again(0).answer, HookAnswer::OldSequence);
  EXPECT_EQ(give(Bench::take(20, 3)).state, HookState::Active);
  EXPECT_EQ(again(1).answer, HookAnswer::OldSequence);
  EXPECT_EQ(again(1).session, 3U);
}

TEST_F(HookbehReplay, AfterARestartWhatCameBeforeTheOneInTheArrayIsOld) {
  give(Bench::take(20));
  give(Bench::descend(25));
  give(Bench::ascend(5));
  bench_.hookbeh = Hookbeh(HookbehArgs{}, kHull);
  EXPECT_EQ(bench_.cycle().answer, HookAnswer::None) << "found in the array";
  const HookbehOutputs out = again(0);
  EXPECT_EQ(out.state, HookState::Ready);
  EXPECT_EQ(out.answer, HookAnswer::OldSequence);
  EXPECT_EQ(give(Bench::take(20, 2)).state, HookState::Active);
}

TEST_F(HookbehReplay, NewerIsLessThanHalfTheCircleAhead) {
  struct Pair {
    uint16_t sequence, other;
    bool newer;
  };
  for (const Pair& pair : {Pair{2, 1, true},
                           {1, 2, false},
                           {1, 1, false},
                           {1, 65535, true},
                           {65535, 1, false},
                           {32768, 1, true},
                           {32769, 1, false},
                           {1, 32769, true},
                           {7, 0, true},
                           {65535, 0, true}}) {
    EXPECT_EQ(hookIsNewerSequence(pair.sequence, pair.other), pair.newer)
        << pair.sequence << " after " << pair.other;
  }
  EXPECT_EQ(hookNextSequence(0), 1);
  EXPECT_EQ(hookNextSequence(65534), 65535);
  EXPECT_EQ(hookNextSequence(65535), 1);
}

TEST_F(HookbehReplay, RoundTheCircleOldOnesStayOld) {
  bench_.sequence = 65533;
  give(Bench::take(20));
  give(Bench::ascend(5));
  bench_.sequence = 0;
  EXPECT_EQ(give(Bench::descend(25)).answer, HookAnswer::Accepted);
  EXPECT_EQ(again(1).answer, HookAnswer::OldSequence) << "65535 is before 1";
  EXPECT_STREQ(wordsFor(again(1).doing), "dive_to");
}

TEST_F(HookbehReplay, HeartbeatsThatComeAgainAreSilence) {
  give(Bench::take(20));
  for (int i = 0; i < 20; ++i) {
    bench_.cycle();
  }
  bench_.alive = false;
  HookbehOutputs out;
  for (int i = 0; i < 6; ++i) {
    ASSERT_NE(out.state, HookState::Silent) << "24 s are not over";
    bench_.inputs.heartbeat = 3 + i;  // recorded earlier
    out = bench_.cycle();
  }
  EXPECT_EQ(out.state, HookState::Silent);
}

TEST_F(HookbehReplay, HeartbeatsCountRound) {
  bench_.beats = kMostSession - 5.0;
  give(Bench::take(20));
  for (int i = 0; i < 40; ++i) {
    bench_.beats = bench_.beats >= kMostSession ? 0 : bench_.beats;
    EXPECT_EQ(bench_.cycle().state, HookState::Active) << i;
  }
}

TEST_F(HookbehReplay, AHeartbeatThatBeganElsewhereCountsFromTheNextTake) {
  bench_.beats = 5000;
  give(Bench::take(20, 1));
  bench_.beats = 100;  // the science computer started again with its clock set back
  HookbehOutputs out;
  for (int i = 0; i < 7; ++i) {
    out = bench_.cycle();
  }
  EXPECT_EQ(out.state, HookState::Silent);
  out = give(Bench::take(20, 2));
  for (int i = 0; i < 30; ++i) {
    EXPECT_EQ(out.state, HookState::Active);
    out = bench_.cycle();
  }
}

TEST_F(HookbehReplay, OldOnesAmongGarbledOnesDoNotHideThatTheSbcIsNotUnderstood) {
  give(Bench::take(20));
  give(Bench::descend(25));
  bench_.write(Bench::ascend(5));
  bench_.inputs.words.check = bench_.inputs.words.check == 1 ? 2 : 1;
  const HookbehInputs garbled = bench_.inputs;
  recorded_.push_back(garbled);
  HookbehOutputs out;
  for (int i = 0; i < 7; ++i) {
    ASSERT_NE(out.state, HookState::Silent);
    out = again(i % 2 == 0 ? 2 : 0);
  }
  EXPECT_EQ(out.state, HookState::Silent);
}

}  // namespace
}  // namespace glider::hooks
