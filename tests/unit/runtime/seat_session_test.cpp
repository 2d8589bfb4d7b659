// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The handshake, the session and the release of a vehicle that has another way to be steered.

#include "runtime/front_seat/seat_session.h"

#include <gtest/gtest.h>

namespace glider::runtime {
namespace {

using hooks::HookAnswer;
using hooks::HookControl;
using hooks::HookState;
using Step = SeatSession::Step;

constexpr SeatHold kAway{.follows = false, .taken = false, .may_begin = true};
constexpr SeatHold kFollows{.follows = true, .taken = false, .may_begin = true};
constexpr SeatHold kFollowsAtDepth{.follows = true, .taken = false, .may_begin = false};
constexpr SeatHold kTaken{.follows = false, .taken = true, .may_begin = true};

hooks::SeatState stateOf(const SeatSession& session) {
  hooks::SeatState state;
  session.describe(&state);
  return state;
}

hooks::Instruction instruction(HookControl control, uint32_t session, uint16_t sequence) {
  hooks::Instruction made;
  made.control = control;
  made.session = session;
  made.sequence = sequence;
  return made;
}

/// Its step, with what is answered to it.
Step give(SeatSession& session, const hooks::Instruction& instruction, HookAnswer answer,
          const SeatHold& hold = kFollows, HookAnswer within = HookAnswer::Accepted) {
  const Step step = session.take(instruction, hold, within);
  EXPECT_EQ(stateOf(session).answer, answer);
  EXPECT_EQ(stateOf(session).answered_sequence, instruction.sequence);
  return step;
}

/// In control with session 7, instruction 1.
SeatSession held() {
  SeatSession session(false);
  session.follow(kFollows);
  EXPECT_EQ(give(session, instruction(HookControl::Take, 7, 1), HookAnswer::Accepted), Step::Steer);
  EXPECT_EQ(stateOf(session).session, 7U);
  EXPECT_EQ(stateOf(session).hook_state, HookState::Active);
  return session;
}

TEST(SeatSession, IsReadyOnceTheVehicleFollows) {
  SeatSession session(false);
  EXPECT_EQ(stateOf(session).hook_state, HookState::Absent);
  EXPECT_FALSE(session.follow(kAway));
  EXPECT_EQ(stateOf(session).hook_state, HookState::Waiting);
  EXPECT_TRUE(session.mayAsk());
  EXPECT_EQ(give(session, instruction(HookControl::Take, 7, 1), HookAnswer::NotReady, kAway),
            Step::Nothing);
  session.follow(kFollows);
  EXPECT_EQ(stateOf(session).hook_state, HookState::Ready);
  session.follow(kTaken);
  EXPECT_EQ(stateOf(session).hook_state, HookState::Absent);
}

TEST(SeatSession, DoesNotBeginWhereNoMissionMay) {
  SeatSession session(false);
  session.follow(kFollowsAtDepth);
  EXPECT_EQ(stateOf(session).hook_state, HookState::Waiting);
  EXPECT_EQ(
      give(session, instruction(HookControl::Take, 7, 1), HookAnswer::NotReady, kFollowsAtDepth),
      Step::Nothing);
  session.follow(kFollows);
  EXPECT_EQ(stateOf(session).hook_state, HookState::Ready);
  EXPECT_EQ(give(session, instruction(HookControl::Take, 7, 2), HookAnswer::Accepted), Step::Steer);
  session.follow(kFollowsAtDepth);
  EXPECT_EQ(stateOf(session).hook_state, HookState::Active);
  EXPECT_EQ(
      give(session, instruction(HookControl::Take, 7, 3), HookAnswer::Accepted, kFollowsAtDepth),
      Step::Steer)
      << "a handshake that is repeated";
}

TEST(SeatSession, WhatGoesOnMayDoSoAnywhere) {
  SeatSession session(true);
  session.follow(kFollowsAtDepth);
  EXPECT_EQ(stateOf(session).hook_state, HookState::Silent);
  EXPECT_EQ(
      give(session, instruction(HookControl::Take, 7, 1), HookAnswer::Accepted, kFollowsAtDepth),
      Step::Steer);
}

TEST(SeatSession, SteersInItsSessionOnly) {
  SeatSession session = held();
  EXPECT_EQ(give(session, instruction(HookControl::Steer, 7, 2), HookAnswer::Accepted),
            Step::Steer);
  EXPECT_EQ(give(session, instruction(HookControl::Steer, 8, 3), HookAnswer::WrongSession),
            Step::Nothing);
  EXPECT_EQ(give(session, instruction(HookControl::Steer, 7, 4), HookAnswer::TooDeep, kFollows,
                 HookAnswer::TooDeep),
            Step::Nothing);
}

TEST(SeatSession, AHandshakeBeyondTheBoundsGivesNoControl) {
  SeatSession session(false);
  session.follow(kFollows);
  EXPECT_EQ(give(session, instruction(HookControl::Take, 7, 1), HookAnswer::TooDeep, kFollows,
                 HookAnswer::TooDeep),
            Step::Nothing);
  EXPECT_FALSE(session.isHeld());
}

TEST(SeatSession, AnOldNumberIsNotObeyed) {
  SeatSession session = held();
  EXPECT_EQ(give(session, instruction(HookControl::Steer, 7, 5), HookAnswer::Accepted),
            Step::Steer);
  EXPECT_EQ(session.take(instruction(HookControl::Steer, 7, 5), kFollows, HookAnswer::Accepted),
            Step::Nothing)
      << "a repetition";
  EXPECT_EQ(stateOf(session).answer, HookAnswer::Accepted);
  EXPECT_EQ(session.take(instruction(HookControl::Steer, 7, 4), kFollows, HookAnswer::Accepted),
            Step::Nothing);
  EXPECT_EQ(stateOf(session).answer, HookAnswer::OldSequence);
}

TEST(SeatSession, WhatIsLostIsTakenAgainByANewHandshake) {
  SeatSession session = held();
  EXPECT_FALSE(session.follow(kFollows));
  EXPECT_TRUE(session.follow(kAway));
  EXPECT_FALSE(session.follow(kAway)) << "said once";
  EXPECT_FALSE(session.isHeld());
  EXPECT_EQ(stateOf(session).hook_state, HookState::Silent);
  EXPECT_FALSE(session.mayAsk()) << "the program has not decided yet";
  give(session, instruction(HookControl::Take, 8, 2), HookAnswer::NotReady, kAway);
  EXPECT_TRUE(session.mayAsk());
  session.follow(kAway);
  EXPECT_EQ(stateOf(session).hook_state, HookState::Waiting);
  session.follow(kFollows);
  EXPECT_EQ(stateOf(session).hook_state, HookState::Silent);
  EXPECT_EQ(give(session, instruction(HookControl::Take, 7, 3), HookAnswer::WrongSession),
            Step::Nothing)
      << "the one that was lost";
  EXPECT_EQ(give(session, instruction(HookControl::Take, 8, 4), HookAnswer::Accepted), Step::Steer);
}

TEST(SeatSession, AProgramThatGoesOnDecidesFirst) {
  SeatSession session(true);
  session.follow(kAway);
  EXPECT_EQ(stateOf(session).hook_state, HookState::Silent);
  EXPECT_FALSE(session.mayAsk());
  EXPECT_TRUE(session.goesOn());
}

TEST(SeatSession, IsReleasedOnceTheVehicleHasLetGo) {
  SeatSession session = held();
  EXPECT_EQ(session.take(instruction(HookControl::Release, 7, 2), kFollows, HookAnswer::Accepted),
            Step::Release);
  EXPECT_TRUE(session.releases());
  EXPECT_EQ(stateOf(session).answered_sequence, 1) << "not before it is so";
  session.noteRelease(false);
  EXPECT_FALSE(session.follow(kAway)) << "it is not lost";
  session.noteRelease(true);
  EXPECT_TRUE(session.isOver());
  EXPECT_FALSE(session.releases());
  EXPECT_FALSE(session.mayAsk());
  EXPECT_EQ(stateOf(session).answered_sequence, 2);
  EXPECT_EQ(stateOf(session).answer, HookAnswer::Accepted);
  EXPECT_EQ(stateOf(session).session, 0U);
  EXPECT_EQ(stateOf(session).hook_state, HookState::Complete);
  session.follow(kFollows);
  EXPECT_EQ(stateOf(session).hook_state, HookState::Complete);
  EXPECT_EQ(give(session, instruction(HookControl::Take, 9, 3), HookAnswer::NotReady),
            Step::Nothing);
}

TEST(SeatSession, ItsReleaseEndsAfterSomeAnswers) {
  SeatSession session = held();
  (void)session.take(instruction(HookControl::Release, 7, 2), kFollows, HookAnswer::Accepted);
  EXPECT_EQ(give(session, instruction(HookControl::Steer, 7, 3), HookAnswer::NotReady),
            Step::Nothing);
  for (uint32_t i = 0; i < SeatSession::kReleaseAnswers; ++i) {
    EXPECT_FALSE(session.isOver()) << i;
    session.noteRelease(false);
  }
  EXPECT_TRUE(session.isOver());
}

/// A program that does not go on has no session to release.
TEST(SeatSession, AProgramThatLeavesReleasesWithoutASession) {
  SeatSession session(true);
  session.follow(kFollows);
  session.leave();
  EXPECT_TRUE(session.releases());
  session.noteRelease(false);
  EXPECT_FALSE(session.isOver());
  EXPECT_EQ(give(session, instruction(HookControl::Take, 7, 1), HookAnswer::NotReady),
            Step::Nothing);
  session.leave();
  for (uint32_t i = 1; i < SeatSession::kReleaseAnswers; ++i) {
    EXPECT_FALSE(session.isOver()) << i;
    session.noteRelease(false);
  }
  EXPECT_TRUE(session.isOver());
  EXPECT_EQ(stateOf(session).answered_sequence, 1);
  EXPECT_EQ(stateOf(session).answer, HookAnswer::NotReady);
  session.leave();
  EXPECT_FALSE(session.releases());
}

TEST(SeatSession, OnlyItsOwnSessionIsReleased) {
  SeatSession session = held();
  EXPECT_EQ(give(session, instruction(HookControl::Release, 8, 2), HookAnswer::WrongSession),
            Step::Nothing);
  EXPECT_TRUE(session.isHeld());
}

}  // namespace
}  // namespace glider::runtime
