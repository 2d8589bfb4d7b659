// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What FlightJudge detects in instructions and in control.

#include "tests/unit/slocum/judged.h"

namespace glider::slocum::oracles {
namespace {

using hooks::HookState;
using Outcome = Verdict::Outcome;

TEST_F(Judged, AGoodFlightExits) {
  take();
  instruct(1, 2, hooks::HookControl::Steer, 15);
  cycle(HookState::Active);
  arrive();
  obey(2);
  fly(80);
  giveBack();
  EXPECT_EQ(judge_.verdict().outcome, Outcome::Exited) << violation();
  EXPECT_EQ(judge_.verdict().instructions, 3U);
  EXPECT_EQ(judge_.verdict().releases, 0U);
}

TEST_F(Judged, AFlightWithoutTheSbcAtTheEndEndsReleased) {
  take();
  cycle(HookState::Silent);
  EXPECT_EQ(judge_.verdict().outcome, Outcome::Released) << violation();
  EXPECT_EQ(judge_.verdict().releases, 1U);
}

TEST_F(Judged, AnInstructionThatDiffersFromWhatWasSentIsSeen) {
  take();
  instruct(1, 2, hooks::HookControl::Steer, 5);
  arrive();
  array_.set(GLIDER_SCI_HOOK_DEPTH, 6);
  obey(2);
  cycle(HookState::Active);
  EXPECT_EQ(violation(), "instruction 2 of session 1 is obeyed, but was sent differently");
}

TEST_F(Judged, AnInstructionObeyedTwiceIsSeen) {
  take();
  instruct(1, 2, hooks::HookControl::Steer, 5);
  arrive();
  obey(2);
  cycle(HookState::Active);
  instruct(1, 1, hooks::HookControl::Take);
  arrive();
  obey(1);
  cycle(HookState::Active);
  EXPECT_EQ(violation(), "instruction 1 of session 1 is obeyed twice");
}

TEST_F(Judged, ANumberThatIsUsedForAnotherInstructionIsSeen) {
  take();
  instruct(1, 1, hooks::HookControl::Take, 12);
  EXPECT_EQ(violation(), "instruction 1 of session 1 is repeated with other content");
}

TEST_F(Judged, ALostInstructionIsSeen) {
  take();
  instruct(1, 2, hooks::HookControl::Steer, 5);
  fly(now_ + 64);
  cycle(HookState::Silent);
  EXPECT_EQ(violation(), "") << "released in time";
  climb();  // nothing is in force
  fly(now_ + 72);
  EXPECT_EQ(violation(), "instruction 2 of session 1 is lost: no answer for 68 s");
}

TEST_F(Judged, AMissionThatMakesNoProgressInControlIsSeen) {
  take();
  for (int i = 0; i < 15; ++i) {
    cycle(HookState::Active);
  }
  EXPECT_EQ(violation().find("made no progress"), std::string::npos);
  cycle(HookState::Active);
  EXPECT_NE(violation().find("made no progress for 68 s"), std::string::npos) << violation();
}

TEST_F(Judged, ControlBeyondTheStatedTimeIsSeen) {
  take();
  fly(240);
  EXPECT_EQ(violation().find("no power"), std::string::npos);
  fly(244);
  EXPECT_EQ(violation(), "the SBC is in control though the SBC has no power");
  EXPECT_EQ(judge_.verdict().violation_s, 244);
}

TEST_F(Judged, ControlWithoutAHandshakeIsSeen) {
  instruct(1, 1, hooks::HookControl::Steer);
  arrive();
  obey(1);
  cycle(HookState::Active);
  EXPECT_EQ(violation(), "control is taken without a handshake");
}

TEST_F(Judged, AnotherSessionWithoutAHandshakeIsSeen) {
  take();
  instruct(2, 2, hooks::HookControl::Steer);
  arrive();
  obey(2, 2);
  cycle(HookState::Active);
  EXPECT_EQ(violation(), "control is taken without a handshake");
}

TEST_F(Judged, AnInstructionAfterControlWasReleasedIsSeen) {
  take();
  giveBack();
  instruct(2, 10, hooks::HookControl::Take);
  arrive();
  obey(10, 2);
  cycle(HookState::Active);
  EXPECT_EQ(violation(), "instruction 10 of session 2 is obeyed after control was released");
}

TEST_F(Judged, WhatArrivesWhenHookbehDoesNotListenIsNotObeyed) {
  take();
  instruct(2, 2, hooks::HookControl::Take);
  arrive();  // x_hook_sequence stays at 1, accepted
  cycle(HookState::Silent);
  cycle(HookState::Complete, 0.1, true);
  EXPECT_EQ(violation(), "");
  EXPECT_EQ(judge_.verdict().instructions, 1U);
}

TEST_F(Judged, AFlightThatDoesNotEndIsSeen) {
  take();
  EXPECT_EQ(violation(), "the flight does not end in time");
  cycle(HookState::Silent, 10);
  EXPECT_EQ(violation(), "") << "it may still come up";
  for (int i = 0; i < 500; ++i) {
    cycle(HookState::Silent, 10);
  }
  EXPECT_EQ(violation(), "still 10.0 m deep though nothing dives any more");
}

TEST_F(Judged, AFlightThatEndsUnderWaterIsSeen) {
  take();
  ended_ = true;
  cycle(HookState::Silent, 10);
  EXPECT_EQ(violation(), "the flight ends under water");
}

}  // namespace
}  // namespace glider::slocum::oracles
