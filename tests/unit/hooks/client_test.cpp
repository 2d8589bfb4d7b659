// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/slocum.h"
#include "tests/unit/hooks/client_bench.h"

#include <algorithm>
#include <string>

namespace glider::hooks {
namespace {

using Type = MessageType;

TEST_F(ClientTest, SaysNothingUnlessSpokenTo) {
  EXPECT_EQ(poll(), ClientEvent::Nothing);
  client_.notify({});
  client_.instruct(descend(HookControl::Take));
  client_.done({}, sbc_);
  EXPECT_TRUE(answers().empty());
}

TEST_F(ClientTest, SendsTheFirstBytesOfALongName) {
  const std::string name(kMostNameBytes + 9, 'n');
  ClientOptions long_name = options();
  long_name.mission_name = name.c_str();
  client_ = Client(gliderDictionary, long_name);
  EXPECT_EQ(link().mission_name, name.substr(0, kMostNameBytes));
}

TEST_F(ClientTest, AnswersABeaconWithHelloAndSubscription) {
  beacon();
  EXPECT_EQ(poll(), ClientEvent::Handled);
  const auto frames = answers();
  ASSERT_EQ(typesOf(frames), (std::vector{Type::Hello, Type::Subscribe, Type::Done}));
  Hello hello;
  ASSERT_TRUE(decode(frames[0], hello));
  EXPECT_STREQ(hello.mission_name, "survey");
  EXPECT_EQ(hello.link, 5U);
  Subscribe subscribe;
  ASSERT_TRUE(decode(frames[1], subscribe));
  EXPECT_EQ(subscribe.count, 2);
  Done done;
  ASSERT_TRUE(decode(frames[2], done));
  EXPECT_EQ(done.answered, said_);
  EXPECT_FALSE(client_.linked());
}

TEST_F(ClientTest, WelcomeMakesTheLinkAndTeachesTheSession) {
  const auto hello = link();
  say(Welcome{true, hello.link, 41});
  EXPECT_EQ(poll(), ClientEvent::Handled);
  EXPECT_EQ(typesOf(answers()), (std::vector{Type::Done}));
  EXPECT_TRUE(client_.linked());
  EXPECT_TRUE(client_.virtualTime());
  client_.instruct(descend(HookControl::Take));
  const auto list = written(tick().at(0));
  EXPECT_EQ(list.values[0].id, GLIDER_SCI_HOOK_SESSION);
  EXPECT_EQ(list.values[0].value, 42) << "newer than any the vehicle knows";
}

TEST_F(ClientTest, ATickOfAnotherLinkIsAnsweredWithHello) {
  head_.link = 99;
  sayTick();
  EXPECT_EQ(poll(), ClientEvent::Handled);
  EXPECT_EQ(typesOf(answers()), (std::vector{Type::Hello, Type::Subscribe, Type::Done}));
}

TEST_F(ClientTest, ALinkThatTheVehicleMayStillTakeIsAskedForAgainAUsedOneIsNot) {
  const auto asked = [&] {
    Hello hello;
    EXPECT_TRUE(decode(answers().at(0), hello));
    return hello.link;
  };
  const uint32_t first = link().link;
  beacon();
  poll();
  EXPECT_EQ(asked(), first) << "the Hello may still be under way";
  head_.link = first + 50;
  sayTick();
  poll();
  EXPECT_EQ(asked(), first);
  head_.link = first;
  tick();
  beacon();
  poll();
  EXPECT_EQ(asked(), first + 1) << "the vehicle had it, and was started again";
}

TEST_F(ClientTest, ALostSubscriptionIsRepeated) {
  link();
  head_.subscription = 0xFFFF;
  EXPECT_EQ(typesOf(tick()), (std::vector{Type::Subscribe, Type::Done}));
  head_.subscription = subscriptionCheck(subscription());
  EXPECT_EQ(typesOf(tick()), (std::vector{Type::Done}));
}

TEST_F(ClientTest, AnotherDictionaryOrVersionIsRefusedOnce) {
  say(Beacon{kProtocolVersion, {}, gliderDictionary.hash + 1, HookState::Ready});
  EXPECT_EQ(poll(), ClientEvent::Refused);
  EXPECT_TRUE(client_.refusal().refused);
  EXPECT_EQ(client_.refusal().dictionary, gliderDictionary.hash + 1);
  EXPECT_EQ(typesOf(answers()).back(), Type::Done);
  say(Beacon{kProtocolVersion, {}, gliderDictionary.hash + 1, HookState::Ready});
  EXPECT_EQ(poll(), ClientEvent::Handled) << "reported once";
  say(Beacon{2, {}, 0, HookState::Ready});
  EXPECT_EQ(poll(), ClientEvent::Refused);
  EXPECT_EQ(client_.refusal().version, 2);
  EXPECT_EQ(client_.refusal().dictionary, 0U) << "of another version none is read";
  answers();
  sayTick();
  EXPECT_EQ(poll(), ClientEvent::Handled) << "no tick of another link is believed";
  EXPECT_EQ(typesOf(answers()), (std::vector{Type::Hello, Type::Subscribe, Type::Done}));
  EXPECT_TRUE(client_.refusal().refused);
  link();
  EXPECT_FALSE(client_.refusal().refused);
}

TEST_F(ClientTest, AVehicleThatLacksOrNeedsAFeatureIsRefusedForEachOnce) {
  constexpr uint16_t kOfLaterVersions = 1U << 9;
  const auto beacon = [&](Features features) {
    say(Beacon{kProtocolVersion, features, gliderDictionary.hash, HookState::Ready});
    const ClientEvent event = poll();
    answers();
    return event;
  };
  EXPECT_EQ(beacon({.offers = 0, .needs = kOfLaterVersions}), ClientEvent::Refused);
  EXPECT_EQ(client_.refusal().missing_features, kOfLaterVersions);
  EXPECT_EQ(beacon({.offers = 0, .needs = kOfLaterVersions}), ClientEvent::Handled) << "once";
  const uint16_t both = kOfLaterVersions | kFeatureVirtualTime;
  EXPECT_EQ(beacon({.offers = both, .needs = both}), ClientEvent::Handled) << "still lacking";
  EXPECT_EQ(client_.refusal().missing_features, kOfLaterVersions);
  EXPECT_FALSE(client_.virtualTime()) << "nothing of a refused vehicle is taken over";
  EXPECT_EQ(beacon({.offers = both, .needs = kFeatureVirtualTime}), ClientEvent::Handled);
  EXPECT_FALSE(client_.refusal().refused);
  EXPECT_TRUE(client_.virtualTime());
}

TEST_F(ClientTest, AFeatureThatTheProgramNeedsMustBeOffered) {
  ClientOptions options;
  options.features = {.offers = kAllFeatures, .needs = kFeatureVirtualTime};
  Client client(gliderDictionary, options);
  for (const bool offered : {false, true}) {
    const Features features{.offers = offered ? kAllFeatures : uint16_t{0}, .needs = 0};
    say(Beacon{kProtocolVersion, features, gliderDictionary.hash, HookState::Ready});
    EXPECT_EQ(client.poll(sbc_, clock_.clock()),
              offered ? ClientEvent::Handled : ClientEvent::Refused);
    Hello hello;
    ASSERT_TRUE(decode(answers().at(0), hello)) << "asked for also then: M5";
    EXPECT_EQ(hello.features, options.features);
  }
}

/// A mission that holds the fin, and a vehicle of before that command.
TEST_F(ClientTest, AFixedFinThatTheVehicleDoesNotObeyIsRefusedByName) {
  ClientOptions options;
  options.features = {.offers = kAllFeatures, .needs = kFeatureFixedFin};
  Client client(gliderDictionary, options);
  const Features old{.offers = kFeatureVirtualTime, .needs = kFeatureVirtualTime};
  say(Beacon{kProtocolVersion, old, gliderDictionary.hash, HookState::Ready});
  EXPECT_EQ(client.poll(sbc_, clock_.clock()), ClientEvent::Refused);
  EXPECT_STREQ(featureName(lowestFeature(client.refusal().missing_features)), "fixed-fin");
}

TEST_F(ClientTest, ActuatorsThatTheVehicleDoesNotObeyAreRefusedByName) {
  ClientOptions options;
  options.features = {.offers = kAllFeatures, .needs = kFeatureActuators};
  Client client(gliderDictionary, options);
  const uint16_t before = kFeatureVirtualTime | kFeatureFixedFin;
  say(Beacon{
      kProtocolVersion, {before, kFeatureVirtualTime}, gliderDictionary.hash, HookState::Ready});
  EXPECT_EQ(client.poll(sbc_, clock_.clock()), ClientEvent::Refused);
  EXPECT_STREQ(featureName(lowestFeature(client.refusal().missing_features)), "actuators");
}

TEST_F(ClientTest, AWelcomeToItsOwnLinkEndsARefusal) {
  link();
  tick();
  say(Beacon{9, {}, 0, HookState::Ready});  // what noise has made of some frame
  EXPECT_EQ(poll(), ClientEvent::Refused);
  Hello hello;
  ASSERT_TRUE(decode(answers().at(0), hello));
  say(Welcome{false, hello.link + 1, 0});
  EXPECT_EQ(poll(), ClientEvent::Handled);
  EXPECT_TRUE(client_.refusal().refused) << "to another link";
  say(Welcome{false, hello.link, 0});
  EXPECT_EQ(poll(), ClientEvent::Handled);
  EXPECT_FALSE(client_.refusal().refused);
  EXPECT_TRUE(client_.linked());
  answers();
  head_.link = hello.link;
  tick();
}

TEST_F(ClientTest, ATickOfItsOwnLinkEndsARefusal) {
  link();
  tick();
  say(Beacon{9, {}, 0, HookState::Ready});
  EXPECT_EQ(poll(), ClientEvent::Refused);
  answers();  // the Hello is lost
  sayTick();
  EXPECT_EQ(poll(), ClientEvent::Handled);
  Hello hello;
  ASSERT_TRUE(decode(answers().at(0), hello)) << "it is asked for again";
  head_.link = hello.link;  // the Welcome is lost
  tick();
  EXPECT_FALSE(client_.refusal().refused);
  EXPECT_TRUE(client_.linked());
}

TEST_F(ClientTest, WhoIsRefusedBeforeAnyLinkBelievesNoWelcomeToNone) {
  say(Welcome{false, 0, 0});
  EXPECT_EQ(poll(), ClientEvent::Handled);
  EXPECT_FALSE(client_.linked());
}

TEST_F(ClientTest, AnUnchangedReadingIsThereWithTheValueThatIsHeld) {
  link();
  tick({{ReadingReport::Value, ReadingReport::Value}, {12.5, 17}});
  ASSERT_EQ(client_.tick().reading_count, 2U);
  tick({{ReadingReport::Nothing, ReadingReport::Unchanged}, {}});
  ASSERT_EQ(client_.tick().reading_count, 1U);
  EXPECT_EQ(client_.tick().readings[0].id, GLIDER_SCI_WATER_TEMP);
  EXPECT_EQ(client_.tick().readings[0].value, 17);
  tick({{ReadingReport::Unchanged, ReadingReport::Value}, {0, 18}});
  ASSERT_EQ(client_.tick().reading_count, 2U);
  EXPECT_EQ(client_.tick().readings[0].value, 12.5);
  EXPECT_EQ(client_.tick().readings[1].value, 18);
}

TEST_F(ClientTest, AReadingThatIsNotHeldIsAskedFor) {
  link();
  EXPECT_EQ(typesOf(tick({{ReadingReport::Unchanged, ReadingReport::Value}, {0, 17}})),
            (std::vector{Type::Subscribe, Type::Done}));
  ASSERT_EQ(client_.tick().reading_count, 1U) << "a known value is still a reading";
  EXPECT_EQ(client_.tick().readings[0].value, 17);
  EXPECT_EQ(typesOf(tick({{ReadingReport::Nothing, ReadingReport::Unchanged}, {}})),
            (std::vector{Type::Subscribe, Type::Done}))
      << "after a new subscription nothing is held";
}

TEST_F(ClientTest, ReadingsOfAnotherSubscriptionAreNotRead) {
  link();
  head_.subscription = 0xFFFF;
  EXPECT_EQ(typesOf(tick({{ReadingReport::Value, ReadingReport::Value}, {12.5, 17}})),
            (std::vector{Type::Subscribe, Type::Done}));
  EXPECT_EQ(client_.tick().reading_count, 0U);
  EXPECT_EQ(client_.tick().cycle, head_.cycle) << "its head counts";
}

TEST_F(ClientTest, ATickThatComesTwiceIsOneTick) {
  link();
  tick();
  --said_;
  sayTick();
  EXPECT_EQ(poll(), ClientEvent::Nothing);
  EXPECT_TRUE(answers().empty());
}

TEST_F(ClientTest, TransitionsTravelBeforeDoneAndAreBounded) {
  link();
  for (uint32_t i = 0; i < 20; ++i) {
    client_.notify({100.0 + i, 0, i, i + 1, 0});
  }
  const auto frames = tick();
  ASSERT_EQ(frames.size(), Client::kMostNotices + 1);
  EXPECT_EQ(frames.back().type, Type::Done);
  TransitionNotice notice;
  ASSERT_TRUE(decode(frames[0], notice));
  EXPECT_EQ(notice.mission_time_s, 100);
}

TEST_F(ClientTest, NotesComeLastBeforeDoneAndAreBounded) {
  link();
  MissionNote note;
  note.text[0] = 'x';
  for (int i = 0; i < 20; ++i) {
    client_.tell(note);
  }
  client_.notify({100.0, 0, 0, 1, 0});
  const auto frames = tick();
  ASSERT_EQ(frames.size(), Client::kMostNotes + 2);
  EXPECT_EQ(frames.front().type, Type::Transition);
  EXPECT_EQ(frames[1].type, Type::Note);
  EXPECT_EQ(frames.back().type, Type::Done);
  EXPECT_EQ(tick().size(), 1U) << "reported once";
}

/// A client whose line takes nothing while it is stuck.

class StuckClientTest : public ClientTest {
 protected:
  static MissionNote noteOf(uint32_t length) {
    MissionNote note;
    std::fill_n(note.text, length, 'x');
    return note;
  }
  template <typename Message>
  static uint32_t bytesOf(const Message& message) {
    Frame frame;
    encode(message, frame);
    uint8_t bytes[kMostEncodedBytes];
    return encodeFrame(frame, bytes);
  }
  /// A tick that is answered with so many notes of the most letters and one of `length`, and one
  /// more letter.
  void tickWithNotes(uint32_t full, uint32_t length) {
    ++head_.cycle;
    sayTick();
    ASSERT_EQ(client_.poll(stream_, clock_.clock()), ClientEvent::Tick);
    for (uint32_t i = 0; i < full; ++i) {
      client_.tell(noteOf(kMostNoteBytes));
    }
    client_.tell(noteOf(length));
    client_.tell(noteOf(1));
    client_.done({}, stream_);
  }
  std::vector<Type> afterwards() {
    stuck_ = false;
    EXPECT_EQ(client_.poll(stream_, clock_.clock()), ClientEvent::Nothing);
    return typesOf(answers());
  }

  bool stuck_ = true;
  GliderByteStream stream_{this,
                           [](void* self, uint8_t* bytes, uint32_t capacity) {
                             const auto& line = static_cast<StuckClientTest*>(self)->sbc_;
                             return line.read(line.self, bytes, capacity);
                           },
                           [](void* self, const uint8_t* bytes, uint32_t count) {
                             const auto* test = static_cast<StuckClientTest*>(self);
                             return test->stuck_ ? 0
                                                 : test->sbc_.write(test->sbc_.self, bytes, count);
                           }};
};

TEST_F(StuckClientTest, NotesLeaveHalfOfItsQueueToTheNextAnswers) {
  constexpr uint32_t kHalf = 1024, kBefore = 6, kFull = 5;
  const uint32_t most = bytesOf(noteOf(kMostNoteBytes)), least = bytesOf(noteOf(0));
  const uint32_t first = (kBefore + 1) * most + bytesOf(noteOf(1)) + bytesOf(Done{});
  const uint32_t rest = kHalf - first - kFull * most;  // bytes of the note that fills the half
  ASSERT_GT(rest, least);
  ASSERT_LE(rest, most);
  for (const uint32_t short_of : {0U, 1U}) {
    client_ = Client(gliderDictionary, options());
    link();
    stuck_ = true;
    tickWithNotes(kBefore, kMostNoteBytes);
    tickWithNotes(kFull, rest - least - short_of);
    std::vector<Type> told(kBefore + 2, Type::Note);
    told.push_back(Type::Done);
    told.insert(told.end(), kFull + 1 + short_of, Type::Note);
    told.push_back(Type::Done);
    EXPECT_EQ(afterwards(), told) << "short of the half by " << short_of;
  }
}

TEST_F(ClientTest, SilenceIsReportedEveryTwelveSecondsButNeverInVirtualTimeOrBeforeTheFirstFrame) {
  clock_.seconds = 100;
  EXPECT_EQ(poll(), ClientEvent::Nothing);
  link();
  clock_.seconds = 111.9;
  EXPECT_EQ(poll(), ClientEvent::Nothing);
  clock_.seconds = 112;
  EXPECT_EQ(poll(), ClientEvent::SilentLink);
  EXPECT_EQ(poll(), ClientEvent::Nothing);
  clock_.seconds = 124;
  EXPECT_EQ(poll(), ClientEvent::SilentLink);
  head_.virtual_time = true;
  tick();
  clock_.seconds = 1000;
  EXPECT_EQ(poll(), ClientEvent::Nothing);
}

TEST_F(ClientTest, BeaconsAreNotTicksSoSilenceGoesOnAmongThem) {
  clock_.seconds = 100;
  link();
  tick();
  int silent = 0;
  for (int i = 0; i < 9; ++i) {
    clock_.seconds += 4;
    beacon();
    EXPECT_EQ(poll(), ClientEvent::Handled);
    silent += poll() == ClientEvent::SilentLink ? 1 : 0;
  }
  EXPECT_EQ(silent, 3);
}

TEST_F(ClientTest, ATickIsAnsweredOnce) {
  link();
  tick();
  client_.done({}, sbc_);
  EXPECT_TRUE(answers().empty());
}

TEST_F(ClientTest, AFrameThatIsNotForItIsHandledAndNotAnswered) {
  say(Done{});
  EXPECT_EQ(poll(), ClientEvent::Handled);
  EXPECT_TRUE(answers().empty());
}

TEST_F(ClientTest, BeforeAnyHelloNoTickIsItsOwn) {
  head_.link = 0;
  sayTick();
  EXPECT_EQ(poll(), ClientEvent::Handled);
  EXPECT_EQ(typesOf(answers()), (std::vector{Type::Hello, Type::Subscribe, Type::Done}));
  EXPECT_FALSE(client_.linked());
}

TEST_F(ClientTest, TicksThatArriveAreNotSilence) {
  link();
  for (int i = 0; i < 10; ++i) {
    clock_.seconds += 4;
    tick();
    EXPECT_EQ(poll(), ClientEvent::Nothing) << i;
  }
  clock_.seconds += 11.9;
  EXPECT_EQ(poll(), ClientEvent::Nothing);
  clock_.seconds += 0.1;
  EXPECT_EQ(poll(), ClientEvent::SilentLink);
}

TEST_F(ClientTest, MoreSensorsThanATickHoldsAreLeftOut) {
  std::vector<Subscription> many(kMostSubscriptions + 3, Subscription{GLIDER_M_DEPTH, 1, 0});
  ClientOptions options;
  options.mission_name = nullptr;
  options.sensors = many.data();
  options.sensor_count = static_cast<uint32_t>(many.size());
  MemoryLine line;
  Client client(gliderDictionary, options);
  putMessage(line.left(), Beacon{kProtocolVersion, {}, gliderDictionary.hash, HookState::Ready}, 1);
  const GliderByteStream right = line.right();
  EXPECT_EQ(client.poll(right, clock_.clock()), ClientEvent::Handled);
  const auto frames = framesAt(line.left());
  ASSERT_EQ(typesOf(frames), (std::vector{Type::Hello, Type::Subscribe, Type::Done}));
  Subscribe subscribe;
  ASSERT_TRUE(decode(frames[1], subscribe));
  EXPECT_EQ(subscribe.count, kMostSubscriptions);
  Hello hello;
  ASSERT_TRUE(decode(frames[0], hello));
  EXPECT_STREQ(hello.mission_name, "");
  EXPECT_EQ(hello.link, 1U) << "sessions begin with 1";
}

TEST_F(ClientTest, ATickThatComesAgainIsNotReadAndANewLinkTellsItApart) {
  const uint32_t first = link().link;
  tick({{ReadingReport::Value, ReadingReport::Value}, {12.5, 17}});
  tick({{ReadingReport::Value, ReadingReport::Value}, {30, 17}});
  head_.cycle -= 1;
  sayTick({{ReadingReport::Value, ReadingReport::Value}, {12.5, 17}});
  EXPECT_EQ(poll(), ClientEvent::Handled);
  EXPECT_EQ(client_.tick().readings[0].value, 30) << "nothing of it is believed";
  const auto frames = answers();
  ASSERT_EQ(typesOf(frames), (std::vector{Type::Hello, Type::Subscribe, Type::Done}));
  Hello hello;
  ASSERT_TRUE(decode(frames[0], hello));
  EXPECT_EQ(hello.link, first + 1);
  sayTick({{ReadingReport::Value, ReadingReport::Value}, {12.5, 17}});
  EXPECT_EQ(poll(), ClientEvent::Handled) << "nor when it comes once more";
  answers();
  head_.link = hello.link;
  head_.cycle = 1;  // or the vehicle has begun to count again
  EXPECT_EQ(typesOf(tick()), (std::vector{Type::Done}));
}

TEST_F(ClientTest, CyclesCountRound) {
  link();
  head_.cycle = kMostSession - 1;
  tick();
  head_.cycle = 0;
  tick();
}

TEST_F(ClientTest, ACycleIsNewUpToHalfOfTheRoundAhead) {
  for (const uint32_t ahead : {8388607U, 8388608U}) {
    client_ = Client(gliderDictionary, options());
    link();
    head_.cycle = 0;
    tick();
    head_.cycle = 1 + ahead;
    sayTick();
    EXPECT_EQ(poll() == ClientEvent::Tick, ahead == 8388607) << ahead;
    answers();
  }
}

TEST_F(ClientTest, AnotherVersionAloneIsRefused) {
  say(Beacon{kProtocolVersion + 1, {}, gliderDictionary.hash, HookState::Ready});
  EXPECT_EQ(poll(), ClientEvent::Refused);
}

TEST_F(ClientTest, AnEarlierSessionTeachesNothing) {
  const Hello hello = link();
  for (const uint32_t newest : {2U, 0U, 4U}) {
    say(Welcome{false, hello.link, newest});
    EXPECT_EQ(poll(), ClientEvent::Handled);
  }
  answers();
  client_.instruct(descend(HookControl::Take));
  EXPECT_EQ(client_.session(), 5U);
  say(Welcome{false, hello.link, 6});
  EXPECT_EQ(poll(), ClientEvent::Handled);
  client_.instruct(descend(HookControl::Take));
  EXPECT_EQ(client_.session(), 7U);
}

TEST_F(ClientTest, NoiseIsNotAFrame) {
  link();
  const uint8_t noise[] = {1, 2, 3, 4, 5, 0, 0, 255, 0};
  vehicle_.write(vehicle_.self, noise, sizeof noise);
  EXPECT_EQ(poll(), ClientEvent::Nothing);
  tick();
}

TEST_F(ClientTest, AClosedLineIsReported) {
  line_.close();
  EXPECT_EQ(poll(), ClientEvent::Closed);
}

}  // namespace
}  // namespace glider::hooks
