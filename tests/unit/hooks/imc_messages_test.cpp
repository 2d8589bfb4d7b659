// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Messages against a second codec, and payloads that are none.

#include "hooks/imc/codec.h"
#include "tests/unit/hooks/imc_named.h"
#include "tests/unit/hooks/imc_streams.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

namespace glider::hooks::imc {
namespace {

using imc_described::described;
using imc_described::leavesOf;
using imc_described::packetOf;
using imc_described::payloadOf;
using imc_described::randomLeaves;
using namespace imc_named;
using imc_streams::kBothOrders;
using imc_streams::kFromVehicle;

/// How many messages of each kind: more in scripts/soak/imc.
int rounds() {
  const char* const given = std::getenv("GLIDER_IMC_ROUNDS");
  return given != nullptr ? std::atoi(given) : 200;
}

/// Calls f(id, values, name) for random messages of each kind.
template <typename F>
void forRandomMessages(int count, F f) {
  std::mt19937 random(11);
  for (const auto& [id, name] : described()) {
    for (int i = 0; i < count; ++i) {
      f(id, randomLeaves(id, random), name);
    }
  }
}

TEST(ImcMessages, AreAllDescribed) {
  std::map<uint16_t, std::string> listed;
#define MESSAGE(name, number) listed[number] = #name;
#define FIELD(type, name)
#define MESSAGE_END
#include "hooks/imc/messages.def"
  EXPECT_EQ(listed, described());
}

TEST(ImcMessages, AreReadAsTheSecondCodecWritesThem) {
  forRandomMessages(rounds(), [](uint16_t id, const Leaves& values, const std::string& name) {
    for (const ByteOrder order : kBothOrders) {
      const Bytes payload = payloadOf(id, values, order);
      EXPECT_TRUE(withMessage(id, [&](auto message) {
        EXPECT_TRUE(decode(packetWith(id, payload, order), message)) << name;
        EXPECT_EQ(leavesOfMessage(message), values) << name;
      })) << name;
    }
  });
}

TEST(ImcMessages, AreWrittenAsTheSecondCodecReadsThem) {
  forRandomMessages(rounds(), [](uint16_t id, const Leaves& values, const std::string& name) {
    EXPECT_TRUE(withMessage(id, [&](auto message) {
      fill(values, message);
      const Bytes packet = encoded(kFromVehicle, message);
      ASSERT_GE(packet.size(), size_t{kHeaderBytes + kCrcBytes}) << name;
      const Bytes payload(packet.begin() + kHeaderBytes, packet.end() - kCrcBytes);
      EXPECT_EQ(leavesOf(id, payload, ByteOrder::Little), values) << name;
      EXPECT_EQ(packet, packetOf(id, kFromVehicle, payload, ByteOrder::Little)) << name;
    }));
  });
}

/// Whole packets of the second codec through the reader, in pieces.
TEST(ImcMessages, ArriveInPacketsOfBothOrders) {
  PacketReader reader;
  forRandomMessages(20, [&reader](uint16_t id, const Leaves& values, const std::string& name) {
    for (const ByteOrder order : kBothOrders) {
      const Bytes bytes = packetOf(id, kFromVehicle, payloadOf(id, values, order), order);
      imc_streams::AllFound found;
      imc_streams::read(&reader, bytes, 13, &found);
      ASSERT_EQ(found.size(), 1U) << name;
      EXPECT_EQ(found[0],
                (imc_streams::Found{id, order, kFromVehicle.time_s, payloadOf(id, values, order)}));
    }
  });
}

TEST(ImcMessages, WithAnotherLengthAreRefused) {
  forRandomMessages(3, [](uint16_t id, const Leaves& values, const std::string& name) {
    for (const ByteOrder order : kBothOrders) {
      const Bytes whole = payloadOf(id, values, order);
      for (size_t size = 0; size < whole.size() + 4; ++size) {
        Bytes other = whole;
        other.resize(size);
        // A copy that ends where its memory ends: reading further is found by the sanitizers.
        const Bytes exact(other.begin(), other.end());
        withMessage(id, [&](auto message) {
          EXPECT_EQ(decode(packetWith(id, exact, order), message), size == whole.size())
              << name << ' ' << size;
        });
      }
    }
  });
}

TEST(ImcMessages, OfAnotherKindAreRefused) {
  const Bytes four(4, 0);
  Temperature temperature;
  EXPECT_TRUE(decode(packetWith(263, four), temperature));
  EXPECT_FALSE(decode(packetWith(269, four), temperature));
  EXPECT_FALSE(decode(packetWith(999, four), temperature));
  Heartbeat heartbeat;
  EXPECT_FALSE(decode(packetWith(Abort::kId, {}), heartbeat));
}

TEST(ImcMessages, ThatDoNotFitAreNotWritten) {
  forRandomMessages(2, [](uint16_t id, const Leaves& values, const std::string& name) {
    withMessage(id, [&](auto message) {
      fill(values, message);
      const auto size = static_cast<uint32_t>(encoded(kFromVehicle, message).size());
      for (uint32_t capacity = 0; capacity <= size; ++capacity) {
        EXPECT_EQ(encoded(kFromVehicle, message, capacity).size(), capacity == size ? size : 0)
            << name;
      }
    });
  });
}

TEST(ImcMessages, AreAsLongAsTheReaderTakesAndNoLonger) {
  const std::string text(70000, 'x');
  FuelLevel level;
  constexpr uint32_t kRest = 4 + 4 + 2;
  level.opmodes = {text.data(), kMostPayload - kRest};
  const Bytes longest = encoded(kFromVehicle, level, 2000);
  EXPECT_EQ(longest.size(), kMostPacket);
  EXPECT_EQ(imc_streams::packetsIn(longest).size(), 1U);
  for (const uint32_t more : {1U, 2U, 3U, 65536U - kMostPayload + kRest}) {
    level.opmodes.size = kMostPayload - kRest + more;
    EXPECT_EQ(encoded(kFromVehicle, level, 2000).size(), 0U);
  }
}

/// The second codec compares bits, which do not tell whether a number may be negative.
TEST(ImcMessages, NumbersMayBeNegative) {
  Rpm rpm;
  ASSERT_TRUE(decode(packetWith(Rpm::kId, {0xD4, 0xFE}), rpm));
  EXPECT_EQ(int{rpm.value}, -300);
  PlanControlState state;
  state.plan_eta = -1;
  state.man_eta = -86400;
  const Leaves leaves = leavesOfMessage(state);
  EXPECT_EQ(std::get<uint64_t>(leaves.at("plan_eta")), 0xFFFFFFFFU);
  EXPECT_LT(state.man_eta, 0);
  FollowReference follow;
  follow.control_src = 0xFFFF;
  EXPECT_GT(follow.control_src, 0);
}

TEST(ImcMessages, AnyNanIsWrittenAsOne) {
  constexpr uint32_t kOther = 0xFFC12345;
  Temperature temperature;
  std::memcpy(&temperature.value, &kOther, sizeof kOther);
  const Bytes packet = encoded(kFromVehicle, temperature);
  EXPECT_EQ(Bytes(packet.begin() + kHeaderBytes, packet.begin() + kHeaderBytes + 4),
            (Bytes{0, 0, 0xC0, 0x7F}));
}

/// A payload of little-endian numbers.
struct Payload {
  Bytes bytes;

  Payload& u8(unsigned value) {
    bytes.push_back(static_cast<uint8_t>(value));
    return *this;
  }
  Payload& u16(unsigned value) { return u8(value % 256).u8(value / 256); }
  Payload& text(const std::string& text) {
    u16(static_cast<unsigned>(text.size()));
    bytes.insert(bytes.end(), text.begin(), text.end());
    return *this;
  }
  Payload& zeros(size_t count) {
    bytes.resize(bytes.size() + count);
    return *this;
  }
};

template <typename Message>
bool isRead(const Payload& payload, Message* message) {
  return decode(packetWith(Message::kId, payload.bytes), *message);
}
template <typename Message>
bool isRead(const Payload& payload) {
  Message message;
  return isRead(payload, &message);
}

constexpr size_t kSpeed = 9, kZ = 5, kPlaceAndRadius = 20;

TEST(ImcMessages, OnlyTheMessageOfAFieldIsReadThere) {
  const auto speed = [](unsigned id) {
    return Payload{}.u8(7).u16(id).zeros(kSpeed).u16(65535).zeros(kPlaceAndRadius);
  };
  EXPECT_TRUE(isRead<Reference>(speed(DesiredSpeed::kId)));
  EXPECT_FALSE(isRead<Reference>(speed(DesiredZ::kId)));
  EXPECT_FALSE(isRead<Reference>(speed(0)));
  EXPECT_FALSE(isRead<Reference>(speed(450)));
  EXPECT_TRUE(isRead<Reference>(
      Payload{}.u8(4).u16(65535).u16(DesiredZ::kId).zeros(kZ).zeros(kPlaceAndRadius)));
  const auto state = [](unsigned id) {
    return Payload{}.u16(1).u8(255).u16(id).u8(1).u16(65535).u16(65535).zeros(kPlaceAndRadius + 2);
  };
  EXPECT_TRUE(isRead<FollowRefState>(state(Reference::kId)));
  EXPECT_FALSE(isRead<FollowRefState>(state(DesiredSpeed::kId)));
}

/// A PlanSpecification with so many elements in a list, and with a maneuver of this kind.
Payload plan(unsigned variables, unsigned maneuvers, unsigned element, unsigned maneuver,
             unsigned transitions = 0) {
  Payload all = Payload{}.text("p").text("").text("").u16(variables).text("1").u16(maneuvers);
  if (maneuvers != 0) {
    all.u16(element).text("1").u16(maneuver);
    all.zeros(maneuver == FollowReference::kId ? 15 : 0).u16(0).u16(0);
  }
  return all.u16(transitions).u16(0).u16(0);
}

TEST(ImcMessages, PlansWithAnythingElseAreRefused) {
  constexpr unsigned kElement = PlanManeuver::kId, kManeuver = FollowReference::kId;
  EXPECT_TRUE(isRead<PlanSpecification>(plan(0, 1, kElement, kManeuver)));
  EXPECT_TRUE(isRead<PlanSpecification>(plan(0, 1, kElement, 65535)));
  EXPECT_TRUE(isRead<PlanSpecification>(plan(0, 0, 0, 0)));
  EXPECT_FALSE(isRead<PlanSpecification>(plan(1, 1, kElement, kManeuver)));
  EXPECT_FALSE(isRead<PlanSpecification>(plan(0, 2, kElement, kManeuver)));
  EXPECT_FALSE(isRead<PlanSpecification>(plan(0, 1, 553, kManeuver)));
  EXPECT_FALSE(isRead<PlanSpecification>(plan(0, 1, 65535, kManeuver)));
  EXPECT_FALSE(isRead<PlanSpecification>(plan(0, 1, kElement, 450)));
  EXPECT_FALSE(isRead<PlanSpecification>(plan(0, 1, kElement, kManeuver, 1)));
}

/// An answer of the vehicle with this argument, and a text behind it.
Payload answer(unsigned id, const Payload& arg) {
  Payload all = Payload{}.u8(1).u8(2).u16(678).text("back_seat").u16(3).u16(id);
  all.bytes.insert(all.bytes.end(), arg.bytes.begin(), arg.bytes.end());
  return all.text("plan loaded");
}

/// What is before an argument that cannot be read is what matters: success or failure, and of what.
TEST(ImcMessages, AnArgumentThatIsNotKnownHidesOnlyWhatFollows) {
  const Payload none = answer(65535, {});
  PlanControl control;
  ASSERT_TRUE(isRead(none, &control));
  EXPECT_FALSE(control.arg.present);
  EXPECT_EQ(control.arg.id, kNoMessage);
  EXPECT_EQ(control.info, textOf("plan loaded"));

  for (const auto& [id, arg] :
       {std::pair{564U, Payload{}.zeros(40)},
        std::pair{unsigned{PlanSpecification::kId}, plan(0, 2, PlanManeuver::kId, 450)},
        std::pair{unsigned{PlanSpecification::kId}, plan(5, 0, 0, 0)}}) {
    const Payload hiding = answer(id, arg);
    ASSERT_TRUE(isRead(hiding, &control)) << id;
    EXPECT_EQ(control.type, 1);
    EXPECT_EQ(control.op, 2);
    EXPECT_EQ(control.request_id, 678);
    EXPECT_EQ(control.plan_id, textOf("back_seat"));
    EXPECT_EQ(control.flags, 3);
    EXPECT_EQ(control.arg.id, id);
    EXPECT_FALSE(control.arg.present);
    EXPECT_EQ(control.arg.value.plan_id, Text{}) << "nothing of it";
    EXPECT_EQ(control.info, Text{});
    EXPECT_EQ(encoded(kFromVehicle, control).size(), 0U) << "it would be another message";
  }
}

TEST(ImcMessages, AnArgumentThatIsCutOffIsRefused) {
  const Payload whole = plan(0, 1, PlanManeuver::kId, FollowReference::kId);
  const Payload answered = answer(PlanSpecification::kId, whole);
  PlanControl control;
  ASSERT_TRUE(isRead(answered, &control));
  EXPECT_TRUE(control.arg.present);
  EXPECT_EQ(control.info, textOf("plan loaded"));
  for (size_t size = 0; size < answered.bytes.size(); ++size) {
    Payload cut = answered;
    cut.bytes.resize(size);
    EXPECT_FALSE(isRead(cut, &control)) << size;
  }
}

TEST(ImcMessages, ATextDoesNotReachBeyondTheEnd) {
  for (const unsigned size : {0U, 1U, 2U, 3U, 255U, 65535U}) {
    Payload payload = Payload{}.zeros(8).u16(size);
    payload.bytes.insert(payload.bytes.end(), {'a', 'b'});
    FuelLevel level;
    EXPECT_EQ(isRead(payload, &level), size == 2) << size;
  }
}

TEST(ImcMessages, TextsAreCompared) {
  EXPECT_EQ(textOf("abc"), (Text{"abcd", 3}));
  EXPECT_FALSE(textOf("abc") == textOf("abd"));
  EXPECT_FALSE(textOf("abc") == textOf("ab"));
  EXPECT_EQ(Text{}, textOf(""));
  EXPECT_EQ(textOf(std::string(70000, 'x').c_str()).size, 70000);
}

}  // namespace
}  // namespace glider::hooks::imc
