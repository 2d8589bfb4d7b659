// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// How the SBC's side orders a nap, and how long it waits for ticks then.

#include "tests/unit/hooks/client_bench.h"

namespace glider::hooks {
namespace {

constexpr Features kOfferNaps{.offers = kFeatureNaps, .needs = 0};

class ClientNapTest : public ClientTest {
 protected:
  ClientNapTest() {
    ClientOptions naps = options();
    naps.features.needs = kFeatureNaps;
    client_ = Client(gliderDictionary, naps);
  }

  void link(const Features& features = kOfferNaps) {
    say(Beacon{kProtocolVersion, features, gliderDictionary.hash, HookState::Ready});
    EXPECT_EQ(poll(), ClientEvent::Handled);
    Hello hello;
    EXPECT_TRUE(decode(answers().at(0), hello));
    head_.link = hello.link;
    head_.subscription = subscriptionCheck(subscription());
  }

  /// The answer to the next Tick, with a nap.
  std::vector<Frame> napAtTick(const Nap& nap) {
    ++head_.cycle;
    sayTick();
    EXPECT_EQ(poll(), ClientEvent::Tick);
    (void)client_.nap(nap);
    client_.done({}, sbc_);
    return answers();
  }

  static Nap nap() {
    Nap nap{20, 100, 1, {}};
    nap.conditions[0] = {GLIDER_M_DEPTH, NapKind::AtLeast, 12};
    return nap;
  }

  ClientEvent after(double seconds) {
    clock_.seconds += seconds;
    return poll();
  }
};

TEST_F(ClientNapTest, ANapComesBeforeDoneOfThatAnswerOnly) {
  link();
  (void)tick();
  const std::vector<Frame> frames = napAtTick(nap());
  EXPECT_EQ(typesOf(frames), (std::vector{MessageType::Nap, MessageType::Done}));
  Nap sent;
  ASSERT_TRUE(decode(frames.at(0), subscription(), sent));
  EXPECT_EQ(sent.length_s, 100);
  EXPECT_EQ(sent.wake_s, 20);
  EXPECT_EQ(sent.conditions[0].value, 12);
  EXPECT_EQ(typesOf(tick()), std::vector{MessageType::Done});
}

TEST_F(ClientNapTest, ANapIsDroppedIfTheAnswerHasAnythingElse) {
  link();
  (void)tick();
  client_.notify({});
  EXPECT_EQ(typesOf(napAtTick(nap())), (std::vector{MessageType::Transition, MessageType::Done}));
  client_.tell({});
  EXPECT_EQ(typesOf(napAtTick(nap())), (std::vector{MessageType::Note, MessageType::Done}));
  client_.instruct(descend(HookControl::Take));
  EXPECT_EQ(typesOf(napAtTick(nap())), (std::vector{MessageType::Write, MessageType::Done}));
}

TEST_F(ClientNapTest, BetweenTicksThereIsNone) {
  link();
  (void)tick();
  client_.nap(nap());
  EXPECT_EQ(typesOf(tick()), std::vector{MessageType::Done});
}

/// The caller may take another frame before it answers.
TEST_F(ClientNapTest, OnlyWithALinkToAVehicleThatOffersNaps) {
  EXPECT_FALSE(client_.mayNap());
  link();
  EXPECT_FALSE(client_.mayNap()) << "without a link";
  (void)tick();
  EXPECT_TRUE(client_.mayNap());
  say(Beacon{kProtocolVersion, Features{}, gliderDictionary.hash, HookState::Ready});
  while (client_.poll(sbc_, clock_.clock()) != ClientEvent::Nothing) {
  }
  EXPECT_FALSE(client_.mayNap()) << "another vehicle";
  (void)answers();
}

TEST_F(ClientNapTest, AProgramThatDoesNotNeedNapsTakesNone) {
  client_ = Client(gliderDictionary, options());
  link();
  (void)tick();
  EXPECT_FALSE(client_.mayNap());
}

TEST_F(ClientNapTest, TheLinkIsSilentOnly36SecondsAfterTheNapAndTheWaking) {
  link();
  (void)napAtTick(nap());
  EXPECT_EQ(after(155.9), ClientEvent::Nothing) << "100 + 20 + 12 + 24 s";
  EXPECT_EQ(after(0.1), ClientEvent::SilentLink);
  EXPECT_EQ(after(11.9), ClientEvent::Nothing);
  EXPECT_EQ(after(0.1), ClientEvent::SilentLink) << "from then on it is awake";
}

TEST_F(ClientNapTest, ATickEndsTheNap) {
  link();
  (void)napAtTick(nap());
  EXPECT_EQ(after(50), ClientEvent::Nothing);
  (void)tick();
  EXPECT_EQ(after(11.9), ClientEvent::Nothing);
  EXPECT_EQ(after(0.1), ClientEvent::SilentLink);
}

TEST_F(ClientNapTest, ANapThatWasNotSentDelaysNothing) {
  link();
  client_.tell({});
  (void)napAtTick(nap());
  EXPECT_EQ(after(12), ClientEvent::SilentLink);
}

TEST_F(ClientNapTest, ATickSaysWhetherItWasKept) {
  link();
  for (const bool kept : {true, false}) {
    head_.kept = kept;
    (void)tick();
    EXPECT_EQ(client_.tick().kept, kept);
  }
}

}  // namespace
}  // namespace glider::hooks
