// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/slocum.h"
#include "tests/unit/hooks/client_bench.h"

#include <algorithm>
#include <string>

// What the client makes of instructions: their numbers, their answers, who is in control.

namespace glider::hooks {
namespace {

using Type = MessageType;

TEST_F(ClientTest, AnInstructionWithoutAnswerGoesWithTheAnswerToTheNextWelcome) {
  link();
  client_.instruct(descend(HookControl::Take));
  tick();
  const auto hello = link();
  say(Welcome{false, hello.link, 0});
  EXPECT_EQ(poll(), ClientEvent::Handled);
  EXPECT_EQ(typesOf(answers()), (std::vector{Type::Write, Type::Done}));
}

TEST_F(ClientTest, AnInstructionGoesRoundedAndCheckedWithItsSequenceLast) {
  link();
  const uint16_t sequence = client_.instruct(descend(HookControl::Take));
  const auto frames = tick();
  ASSERT_EQ(typesOf(frames), (std::vector{Type::Write, Type::Done}));
  const auto list = written(frames[0]);
  ASSERT_EQ(list.count, 11U) << "no mission that samples";
  EXPECT_EQ(list.values[3].id, GLIDER_SCI_HOOK_DEPTH);
  EXPECT_EQ(list.values[3].value, static_cast<double>(20.1F));
  EXPECT_EQ(list.values[10].id, GLIDER_SCI_HOOK_SEQUENCE);
  EXPECT_EQ(list.values[10].value, sequence);
  Done done;
  ASSERT_TRUE(decode(frames[1], done));
  EXPECT_EQ(done.session, 5U);
}

TEST_F(ClientTest, AnUnansweredInstructionIsWrittenAgainWithTheSameNumber) {
  link();
  const uint16_t sequence = client_.instruct(descend(HookControl::Take));
  for (int round = 0; round < 9; ++round) {
    const auto frames = tick();
    ASSERT_EQ(typesOf(frames), (std::vector{Type::Write, Type::Done}));
    EXPECT_EQ(written(frames[0]).values[10].value, sequence);
  }
  head_.answered_sequence = sequence;
  head_.answer = HookAnswer::Accepted;
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(typesOf(tick()), (std::vector{Type::Done}));
  }
}

TEST_F(ClientTest, ABadCheckIsRepairedAtOnceARefusalIsNotRepeated) {
  link();
  const uint16_t sequence = client_.instruct(descend(HookControl::Take));
  tick();
  head_.answered_sequence = sequence;
  head_.answer = HookAnswer::BadCheck;
  EXPECT_EQ(typesOf(tick()), (std::vector{Type::Write, Type::Done}));
  head_.answer = HookAnswer::TooDeep;
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(typesOf(tick()), (std::vector{Type::Done}));
  }
}

TEST_F(ClientTest, WhoIsNotAnsweredDoesNotClaimControl) {
  link();
  const auto claimed = [](const std::vector<Frame>& frames) {
    Done done;
    EXPECT_TRUE(decode(frames.back(), done));
    return done.session;
  };
  client_.instruct(descend(HookControl::Take));
  tick();
  for (uint32_t i = 1; i <= 8; ++i) {
    EXPECT_EQ(claimed(tick()), i < Client::kMostUnansweredTicks ? 5U : 0U) << i;
    EXPECT_EQ(client_.tick().unanswered_ticks, i);
  }
  head_.answered_sequence = 1;
  head_.answer = HookAnswer::BadCheck;
  EXPECT_EQ(claimed(tick()), 5U) << "something got through";
  for (uint32_t i = 1; i <= 8; ++i) {
    EXPECT_EQ(claimed(tick()), i < Client::kMostUnansweredTicks ? 5U : 0U) << "but never whole";
  }
  head_.answer = HookAnswer::Accepted;
  EXPECT_EQ(claimed(tick()), 5U);
  EXPECT_EQ(client_.tick().unanswered_ticks, 0U);
}

TEST_F(ClientTest, ANewInstructionInEveryTickIsAnsweredWhenEarlierOnesAre) {
  link();
  for (int i = 0; i < 30; ++i) {
    const uint16_t sequence = client_.instruct(descend(HookControl::Take));
    tick();
    EXPECT_LE(client_.tick().unanswered_ticks, 1U);
    head_.answered_sequence = static_cast<uint16_t>(sequence - 1);  // always one behind
    head_.answer = HookAnswer::Accepted;
  }
}

TEST_F(ClientTest, ASteerBeforeItsTakeWasAcceptedGoesAsTake) {
  link();
  client_.instruct(descend(HookControl::Take));
  tick();
  client_.instruct(descend(HookControl::Steer));
  auto list = written(tick().at(0));
  EXPECT_EQ(list.values[0].value, 5);
  EXPECT_EQ(list.values[1].value, static_cast<double>(HookControl::Take));
  head_.hook_state = HookState::Active;
  head_.session = 5;
  tick();
  client_.instruct(descend(HookControl::Steer));
  list = written(tick().at(0));
  EXPECT_EQ(list.values[1].value, static_cast<double>(HookControl::Steer));
}

TEST_F(ClientTest, EachTakeOpensANewSession) {
  link();
  client_.instruct(descend(HookControl::Take));
  EXPECT_EQ(written(tick().at(0)).values[0].value, 5);
  client_.instruct(descend(HookControl::Take));
  EXPECT_EQ(written(tick().at(0)).values[0].value, 6);
}

TEST_F(ClientTest, SequenceAvoidsTheOneThatLiesInTheArray) {
  link();
  head_.answered_sequence = 1;
  tick();
  EXPECT_EQ(client_.instruct(descend(HookControl::Take)), 2);
}

TEST_F(ClientTest, ANumberThatTheVehicleFoundAtItsStartIsGivenUp) {
  link();
  const uint16_t dead = client_.instruct(descend(HookControl::Take));
  tick();
  head_.answered_sequence = dead;  // hookbeh restarted and took it for an old one
  const auto frames = tick();
  ASSERT_EQ(typesOf(frames), (std::vector{Type::Write, Type::Done}));
  EXPECT_EQ(client_.tick().instruction_sequence, dead + 1);
  const auto list = written(frames.at(0));
  EXPECT_EQ(list.values[10].value, dead + 1);
  EXPECT_EQ(written(tick().at(0)).values[10].value, dead + 1) << "not another one in every tick";
  head_.answered_sequence = static_cast<uint16_t>(dead + 1);
  head_.answer = HookAnswer::Accepted;
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(typesOf(tick()), (std::vector{Type::Done}));
  }
}

TEST_F(ClientTest, WhoIsStartedAgainClaimsControlWithItsFirstInstruction) {
  client_.resume(7, 40);
  link();
  head_.session = 7;
  head_.hook_state = HookState::Active;
  const auto claimed = [&] {
    Done done;
    EXPECT_TRUE(decode(tick().back(), done));
    return done.session;
  };
  EXPECT_EQ(claimed(), 0U);
  EXPECT_EQ(claimed(), 0U);
  const uint16_t sequence = client_.instruct(descend(HookControl::Steer));
  EXPECT_EQ(sequence, 41);
  EXPECT_EQ(claimed(), 7U);
}

TEST_F(ClientTest, AProgramThatKnowsNothingBeginsBehindTheNumberThatWasDecidedOn) {
  link();
  head_.answered_sequence = 40000;
  head_.answer = HookAnswer::Accepted;
  tick();
  EXPECT_EQ(client_.instruct(descend(HookControl::Take)), 40001);
}

TEST_F(ClientTest, ANumberThatIsOldIsGivenUpForANewerOne) {
  for (uint32_t settled = 100; settled <= UINT16_MAX; settled += 6500) {
    client_ = Client(gliderDictionary, options());
    link();
    head_.answered_sequence = 7;  // one that came again hides what was decided on
    head_.answer = HookAnswer::OldSequence;
    tick();
    client_.instruct(descend(HookControl::Take));
    int refusals = 0;
    for (; refusals < 10; ++refusals) {
      const auto list = written(tick().at(0));
      head_.answered_sequence = static_cast<uint16_t>(list.values[10].value);
      EXPECT_EQ(client_.tick().instruction_sequence, head_.answered_sequence);
      if (hookIsNewerSequence(head_.answered_sequence, static_cast<uint16_t>(settled))) {
        break;
      }
    }
    EXPECT_LE(refusals, 3) << settled;
    head_.answer = HookAnswer::Accepted;
    EXPECT_EQ(typesOf(tick()), (std::vector{Type::Done})) << settled;
  }
}

TEST_F(ClientTest, TheRefusalOfAnOldInstructionDoesNotAnswerTheOneThatWaits) {
  link();
  client_.instruct(descend(HookControl::Take));
  tick();
  for (uint32_t i = 1; i <= 8; ++i) {
    head_.answered_sequence = static_cast<uint16_t>(60000 + i);
    head_.answer = HookAnswer::OldSequence;
    EXPECT_EQ(typesOf(tick()), (std::vector{Type::Write, Type::Done})) << "written again";
    EXPECT_EQ(client_.tick().unanswered_ticks, i);
  }
}

TEST_F(ClientTest, ATakeThatWasAcceptedStaysAccepted) {
  link();
  client_.instruct(descend(HookControl::Take));
  tick();
  head_.hook_state = HookState::Active;
  head_.session = 5;
  tick();
  EXPECT_TRUE(client_.tick().obeys_us);
  head_.hook_state = HookState::Silent;
  tick();
  EXPECT_FALSE(client_.tick().obeys_us);
  client_.instruct(descend(HookControl::Steer));
  EXPECT_EQ(written(tick().at(0)).values[1].value, static_cast<double>(HookControl::Steer));
}

TEST_F(ClientTest, ItsNumbersFollowThoseThatWereDecidedOnIfAnyWere) {
  link();
  head_.answered_sequence = 7;
  head_.answer = HookAnswer::OldSequence;
  tick();
  EXPECT_EQ(client_.instruct(descend(HookControl::Take)), 8) << "nothing else is known";
  head_.answered_sequence = 20000;
  head_.answer = HookAnswer::Accepted;
  tick();
  head_.answered_sequence = 7;
  head_.answer = HookAnswer::OldSequence;
  tick();
  EXPECT_EQ(client_.instruct(descend(HookControl::Take)), 20001);
}

TEST_F(ClientTest, AnAnsweredInstructionIsNotWrittenAgain) {
  link();
  head_.answered_sequence = client_.instruct(descend(HookControl::Take));
  head_.answer = HookAnswer::Accepted;
  EXPECT_EQ(typesOf(tick()), (std::vector{Type::Done})) << "it was there already";
  EXPECT_EQ(typesOf(tick()), (std::vector{Type::Done}));
}

}  // namespace
}  // namespace glider::hooks
