// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/client/client.h"

#include "tests/unit/hooks/line_ends.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace glider::hooks {
namespace {

using Type = MessageType;

/// A client whose vehicle is the test.
class ClientTest : public testing::Test {
 protected:
  ClientTest() : client_(options()) {}

  static ClientOptions options() {
    static const Subscription sensors[] = {{GLIDER_M_DEPTH}, {GLIDER_SCI_WATER_TEMP, 2, 0.5F}};
    ClientOptions options;
    options.mission_name = "survey";
    options.session = 5;
    options.sensors = sensors;
    options.sensor_count = 2;
    return options;
  }

  ClientEvent poll() { return client_.poll(sbc_, clock_.clock()); }
  std::vector<Frame> answers() { return framesAt(vehicle_); }

  static Subscribe subscription() { return {2, {options().sensors[0], options().sensors[1]}}; }

  template <typename Message>
  void say(const Message& message) {
    putMessage(vehicle_, message, ++said_);
  }

  void beacon() { say(Beacon{kProtocolVersion, false, dictionaryHash(), HookState::Ready}); }

  Hello link() {
    beacon();
    EXPECT_EQ(poll(), ClientEvent::Handled);
    const auto frames = answers();
    Hello hello;
    EXPECT_TRUE(decode(frames.at(0), hello));
    head_.link = hello.link;
    head_.subscription = subscriptionCheck(subscription());
    head_.hook_state = HookState::Ready;
    return hello;
  }

  void sayTick(const TickReadings& readings = {}) {
    Frame frame;
    encode(head_, subscription(), readings, frame);
    frame.sequence = ++said_;
    put(vehicle_, frame);
  }

  /// One cycle of the vehicle; returns the frames of the answer.
  std::vector<Frame> tick(const TickReadings& readings = {}) {
    ++head_.cycle;
    sayTick(readings);
    EXPECT_EQ(poll(), ClientEvent::Tick);
    client_.done({}, sbc_);
    return answers();
  }

  static SensorList written(const Frame& frame) {
    SensorList list;
    EXPECT_TRUE(decodeList(frame, list));
    return list;
  }

  static Instruction descend(HookControl control) {
    Instruction instruction;
    instruction.control = control;
    instruction.vertical = HookVertical::Descend;
    instruction.depth_m = 20.1;
    instruction.pitch_rad = -0.4;
    return instruction;
  }

  MemoryLine line_;
  GliderByteStream vehicle_ = line_.left();
  GliderByteStream sbc_ = line_.right();
  HandClock clock_;
  Client client_;
  TickHead head_;
  uint8_t said_ = 0;
};

TEST_F(ClientTest, SaysNothingUnlessSpokenTo) {
  EXPECT_EQ(poll(), ClientEvent::Nothing);
  client_.notify({});
  client_.instruct(descend(HookControl::Take));
  client_.done({}, sbc_);
  EXPECT_TRUE(answers().empty());
}

TEST_F(ClientTest, TellsTheFirstBytesOfALongName) {
  const std::string name(kMostNameBytes + 9, 'n');
  ClientOptions long_name = options();
  long_name.mission_name = name.c_str();
  client_ = Client(long_name);
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

TEST_F(ClientTest, AnInstructionWithoutAnswerGoesWithTheAnswerToTheNextWelcome) {
  link();
  client_.instruct(descend(HookControl::Take));
  tick();
  const auto hello = link();
  say(Welcome{false, hello.link, 0});
  EXPECT_EQ(poll(), ClientEvent::Handled);
  EXPECT_EQ(typesOf(answers()), (std::vector{Type::Write, Type::Done}));
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
  say(Beacon{kProtocolVersion, false, dictionaryHash() + 1, HookState::Ready});
  EXPECT_EQ(poll(), ClientEvent::Refused);
  EXPECT_TRUE(client_.refusal().refused);
  EXPECT_EQ(client_.refusal().dictionary, dictionaryHash() + 1);
  EXPECT_EQ(typesOf(answers()).back(), Type::Done);
  say(Beacon{kProtocolVersion, false, dictionaryHash() + 1, HookState::Ready});
  EXPECT_EQ(poll(), ClientEvent::Handled) << "told once";
  say(Beacon{2, false, 0, HookState::Ready});
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

TEST_F(ClientTest, AWelcomeToItsOwnLinkEndsARefusal) {
  link();
  tick();
  say(Beacon{9, false, 0, HookState::Ready});  // what noise has made of some frame
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
  say(Beacon{9, false, 0, HookState::Ready});
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
  tick({{Told::Value, Told::Value}, {12.5, 17}});
  ASSERT_EQ(client_.tick().reading_count, 2U);
  tick({{Told::Nothing, Told::Unchanged}, {}});
  ASSERT_EQ(client_.tick().reading_count, 1U);
  EXPECT_EQ(client_.tick().readings[0].id, GLIDER_SCI_WATER_TEMP);
  EXPECT_EQ(client_.tick().readings[0].value, 17);
  tick({{Told::Unchanged, Told::Value}, {0, 18}});
  ASSERT_EQ(client_.tick().reading_count, 2U);
  EXPECT_EQ(client_.tick().readings[0].value, 12.5);
  EXPECT_EQ(client_.tick().readings[1].value, 18);
}

TEST_F(ClientTest, AReadingThatIsNotHeldIsAskedFor) {
  link();
  EXPECT_EQ(typesOf(tick({{Told::Unchanged, Told::Value}, {0, 17}})),
            (std::vector{Type::Subscribe, Type::Done}));
  ASSERT_EQ(client_.tick().reading_count, 1U) << "what is known is a reading all the same";
  EXPECT_EQ(client_.tick().readings[0].value, 17);
  EXPECT_EQ(typesOf(tick({{Told::Nothing, Told::Unchanged}, {}})),
            (std::vector{Type::Subscribe, Type::Done}))
      << "who subscribes anew holds nothing";
}

TEST_F(ClientTest, ReadingsOfAnotherSubscriptionAreNotRead) {
  link();
  head_.subscription = 0xFFFF;
  EXPECT_EQ(typesOf(tick({{Told::Value, Told::Value}, {12.5, 17}})),
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

TEST_F(ClientTest, AnInstructionGoesRoundedAndCheckedWithItsSequenceLast) {
  link();
  const uint16_t sequence = client_.instruct(descend(HookControl::Take));
  const auto frames = tick();
  ASSERT_EQ(typesOf(frames), (std::vector{Type::Write, Type::Done}));
  const auto list = written(frames[0]);
  ASSERT_EQ(list.count, 11U);
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
  EXPECT_EQ(tick().size(), 1U) << "told once";
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
    client_ = Client(options());
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

TEST_F(ClientTest, SilenceIsToldEveryTwelveSecondsButNeverInVirtualTimeOrBeforeTheFirstFrame) {
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

TEST_F(ClientTest, BeaconsAreNoTicksSoSilenceGoesOnAmongThem) {
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

TEST_F(ClientTest, ANumberThatTheVehicleFoundAtItsStartIsGivenUp) {
  link();
  const uint16_t dead = client_.instruct(descend(HookControl::Take));
  tick();
  head_.answered_sequence = dead;  // hookbeh began anew and took it for an old one
  const auto frames = tick();
  ASSERT_EQ(typesOf(frames), (std::vector{Type::Write, Type::Done}));
  EXPECT_EQ(client_.tick().instruction_sequence, dead + 1);
  const auto list = written(frames.at(0));
  EXPECT_EQ(list.values[list.count - 1].value, dead + 1);
  EXPECT_EQ(written(tick().at(0)).values[10].value, dead + 1) << "not another one in every tick";
  head_.answered_sequence = static_cast<uint16_t>(dead + 1);
  head_.answer = HookAnswer::Accepted;
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(typesOf(tick()), (std::vector{Type::Done}));
  }
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

TEST_F(ClientTest, TicksThatComeAreNoSilence) {
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

TEST_F(ClientTest, MoreSensorsThanATickHoldsAreLeftOut) {
  std::vector<Subscription> many(kMostSubscriptions + 3, Subscription{GLIDER_M_DEPTH, 1, 0});
  ClientOptions options;
  options.mission_name = nullptr;
  options.sensors = many.data();
  options.sensor_count = static_cast<uint32_t>(many.size());
  MemoryLine line;
  Client client(options);
  putMessage(line.left(), Beacon{kProtocolVersion, false, dictionaryHash(), HookState::Ready}, 1);
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
  tick({{Told::Value, Told::Value}, {12.5, 17}});
  tick({{Told::Value, Told::Value}, {30, 17}});
  head_.cycle -= 1;
  sayTick({{Told::Value, Told::Value}, {12.5, 17}});
  EXPECT_EQ(poll(), ClientEvent::Handled);
  EXPECT_EQ(client_.tick().readings[0].value, 30) << "nothing of it is believed";
  const auto frames = answers();
  ASSERT_EQ(typesOf(frames), (std::vector{Type::Hello, Type::Subscribe, Type::Done}));
  Hello hello;
  ASSERT_TRUE(decode(frames[0], hello));
  EXPECT_EQ(hello.link, first + 1);
  sayTick({{Told::Value, Told::Value}, {12.5, 17}});
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
    client_ = Client(options());
    link();
    head_.cycle = 0;
    tick();
    head_.cycle = 1 + ahead;
    sayTick();
    EXPECT_EQ(poll() == ClientEvent::Tick, ahead == 8388607) << ahead;
    answers();
  }
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
    client_ = Client(options());
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
      if (isNewerSequence(head_.answered_sequence, static_cast<uint16_t>(settled))) {
        break;
      }
    }
    EXPECT_LE(refusals, 3) << settled;
    head_.answer = HookAnswer::Accepted;
    EXPECT_EQ(typesOf(tick()), (std::vector{Type::Done})) << settled;
  }
}

TEST_F(ClientTest, ThatAnOldInstructionIsRefusedIsNoAnswerToTheOneThatWaits) {
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

TEST_F(ClientTest, AnotherVersionAloneIsRefused) {
  say(Beacon{kProtocolVersion + 1, false, dictionaryHash(), HookState::Ready});
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

TEST_F(ClientTest, NoiseIsNoFrame) {
  link();
  const uint8_t noise[] = {1, 2, 3, 4, 5, 0, 0, 255, 0};
  vehicle_.write(vehicle_.self, noise, sizeof noise);
  EXPECT_EQ(poll(), ClientEvent::Nothing);
  tick();
}

TEST_F(ClientTest, AClosedLineIsTold) {
  line_.close();
  EXPECT_EQ(poll(), ClientEvent::Closed);
}

}  // namespace
}  // namespace glider::hooks
