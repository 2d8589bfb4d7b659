// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Packets of a real vehicle and of its clients.

#include "hooks/imc/codec.h"
#include "hooks/imc/crc.h"
#include "hooks/imc/values.h"
#include "tests/unit/hooks/imc_streams.h"

#include <gtest/gtest.h>

#include <string_view>

namespace glider::hooks::imc {
namespace {

using imc_samples::kSampleCount;
using imc_samples::kSamples;
using namespace imc_streams;

/// A sample and the reader that holds its payload.
struct Arrived {
  PacketReader reader;
  Packet packet;
  Bytes bytes;

  Arrived(std::string_view name, ByteOrder order) {
    for (uint32_t i = 0; i < kSampleCount; ++i) {
      bytes = kSamples[i].name == name ? sampleBytes(i, order) : bytes;
    }
    EXPECT_EQ(reader.push(bytes.data(), static_cast<uint32_t>(bytes.size())), bytes.size());
    EXPECT_TRUE(reader.next(&packet)) << name;
  }
};

template <typename Message>
Message arrived(std::string_view name, ByteOrder order) {
  const Arrived sample(name, order);
  Message message;
  EXPECT_TRUE(decode(sample.packet, message)) << name;
  return message;
}

template <typename Message>
void expectBytes(std::string_view name, const Message& message) {
  const Arrived sample(name, ByteOrder::Little);
  uint8_t bytes[kMostPacket];
  const uint32_t size = encode(sample.packet.header, message, bytes, sizeof bytes);
  EXPECT_EQ(Bytes(bytes, bytes + size), sample.bytes) << name;
}

TEST(ImcPackets, TheCrcHasItsCheckValue) {
  const uint8_t digits[] = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
  EXPECT_EQ(crc16Arc(digits, sizeof digits), 0xBB3D);
  EXPECT_EQ(crc16Arc(digits, 0), 0);
}

/// Each byte of each sample, in both orders, is understood and written again.
TEST(ImcPackets, AreReadAndWrittenAgain) {
  for (const auto& [name, id, little, big] : kSamples) {
    for (const ByteOrder order : kBothOrders) {
      Arrived sample(name, order);
      EXPECT_EQ(sample.packet.id, id);
      EXPECT_EQ(sample.packet.order, order) << name;
      EXPECT_EQ(sample.packet.size, sample.bytes.size() - kHeaderBytes - kCrcBytes) << name;
      uint8_t again[kMostPacket];
      uint32_t size = 0;
#define MESSAGE(type, number)                                          \
  if (id == (number)) {                                                \
    type message;                                                      \
    EXPECT_TRUE(decode(sample.packet, message)) << name;               \
    size = encode(sample.packet.header, message, again, sizeof again); \
  }
#define FIELD(type, field)
#define MESSAGE_END
#include "hooks/imc/messages.def"
      EXPECT_EQ(Bytes(again, again + size), bytesOf(little)) << name;
      EXPECT_FALSE(sample.reader.next(&sample.packet)) << name;
      EXPECT_EQ(sample.reader.skippedBytes(), 0U) << name;
    }
  }
}

TEST(ImcPackets, HaveTheirHeaders) {
  for (const ByteOrder order : kBothOrders) {
    const Header start = Arrived("PlanControlStart", order).packet.header;
    EXPECT_EQ(start.source, 0x4001);
    EXPECT_EQ(start.source_entity, kAnyEntity);
    EXPECT_EQ(start.destination, 0x00D1);
    EXPECT_EQ(start.destination_entity, kAnyEntity);
    const Header state = Arrived("EstimatedState", order).packet.header;
    EXPECT_EQ(state.source, 0x00D1);
    EXPECT_EQ(state.source_entity, 0x32);
    EXPECT_EQ(state.destination, kAllSystems);
    EXPECT_EQ(state.destination_entity, kAnyEntity);
    EXPECT_EQ(Arrived("Heartbeat", order).packet.header.time_s, 1234567890.5);
    EXPECT_NEAR(state.time_s, 1795622130, 86400) << "25 Nov 2026";
  }
}

TEST(ImcPackets, ReadingsOfTheVehicle) {
  for (const ByteOrder order : kBothOrders) {
    const auto state = arrived<EstimatedState>("EstimatedState", order);
    EXPECT_NEAR(state.lat, 0.7188, 1e-4);
    EXPECT_NEAR(state.lon, -0.1519, 1e-4);
    EXPECT_NEAR(state.height, 0, 1e-6);
    EXPECT_NEAR(state.x, 0.295, 1e-3);
    EXPECT_NEAR(state.depth, 0.0319, 1e-4);
    EXPECT_NEAR(state.alt, 4.474, 1e-3);
    EXPECT_NEAR(arrived<Temperature>("Temperature", order).value, 15.469, 1e-3);
    EXPECT_NEAR(arrived<Conductivity>("Conductivity", order).value, 3.4734, 1e-4);
    EXPECT_NEAR(arrived<Salinity>("Salinity", order).value, 27.3265, 1e-4);
    EXPECT_EQ(arrived<VehicleMedium>("VehicleMedium", order).medium, Medium::WaterSurface);
  }
}

TEST(ImcPackets, StatesOfTheVehicle) {
  for (const ByteOrder order : kBothOrders) {
    const auto state = arrived<FollowRefState>("FollowRefState", order);
    EXPECT_EQ(state.control_src, 0x4001);
    EXPECT_EQ(state.control_ent, kAnyEntity);
    EXPECT_EQ(state.state, FollowState::Wait);
    EXPECT_EQ(state.proximity, Proximity::Far);
    ASSERT_TRUE(state.reference.present);
    const Reference& reference = state.reference.value;
    EXPECT_EQ(reference.flags, ReferenceFlag::Location | ReferenceFlag::Speed | ReferenceFlag::Z);
    EXPECT_TRUE(reference.speed.present);
    EXPECT_EQ(reference.speed.value.value, 1.2);
    EXPECT_EQ(reference.speed.value.speed_units, SpeedUnits::MetresPerSecond);
    EXPECT_TRUE(reference.z.present);
    EXPECT_EQ(reference.z.value.value, 1.0F);
    EXPECT_EQ(reference.z.value.z_units, ZUnits::Depth);
    EXPECT_FALSE(arrived<FollowRefState>("FollowRefStateWait", order).reference.present);
  }
}

/// The texts of a decoded message are in its packet.
TEST(ImcPackets, APlan) {
  for (const ByteOrder order : kBothOrders) {
    const Arrived sample("PlanControlStart", order);
    PlanControl control;
    ASSERT_TRUE(decode(sample.packet, control));
    EXPECT_EQ(control.type, PlanControlType::Request);
    EXPECT_EQ(control.op, PlanOperation::Start);
    EXPECT_EQ(control.request_id, 678);
    EXPECT_EQ(control.plan_id, textOf("back_seat"));
    EXPECT_EQ(control.info, textOf(""));
    ASSERT_TRUE(control.arg.present);
    EXPECT_EQ(control.arg.id, PlanSpecification::kId);
    const PlanSpecification& plan = control.arg.value;
    EXPECT_EQ(plan.plan_id, textOf("back_seat"));
    EXPECT_EQ(plan.start_man_id, textOf("1"));
    ASSERT_TRUE(plan.maneuvers.present);
    EXPECT_EQ(plan.maneuvers.value.maneuver_id, textOf("1"));
    ASSERT_TRUE(plan.maneuvers.value.data.present);
    const FollowReference& follow = plan.maneuvers.value.data.value;
    EXPECT_EQ(follow.control_src, 0x4001);
    EXPECT_EQ(follow.control_ent, kAnyEntity);
    EXPECT_EQ(follow.timeout, 15);
    EXPECT_EQ(follow.loiter_radius, 10);
    EXPECT_EQ(follow.altitude_interval, 0.5);
  }
}

/// The other way: all fields set here, none taken from a packet.
TEST(ImcPackets, AreWhatTheirFieldsMake) {
  expectBytes("Heartbeat", Heartbeat{});
  expectBytes("VehicleMedium", VehicleMedium{.medium = Medium::WaterSurface});
  expectBytes("FollowRefStateWait", FollowRefState{.control_src = 0x4001,
                                                   .control_ent = kAnyEntity,
                                                   .reference = {},
                                                   .state = FollowState::Wait,
                                                   .proximity = Proximity::Far});
  expectBytes("VehicleState", VehicleState{.maneuver_type = kNoMessage,
                                           .maneuver_stime = -1,
                                           .maneuver_eta = 0xFFFF,
                                           .last_error_time = -1});
  expectBytes("PlanControlState", PlanControlState{.state = PlanState::Ready,
                                                   .plan_id = textOf("back_seat"),
                                                   .plan_progress = -1,
                                                   .man_type = kNoMessage,
                                                   .man_eta = 0xFFFF,
                                                   .last_outcome = PlanOutcome::Failure});
  PlanControl start{.type = PlanControlType::Request,
                    .op = PlanOperation::Start,
                    .request_id = 678,
                    .plan_id = textOf("back_seat")};
  start.arg.present = true;
  PlanSpecification& plan = start.arg.value;
  plan.plan_id = textOf("back_seat");
  plan.start_man_id = textOf("1");
  plan.maneuvers.present = true;
  plan.maneuvers.value.maneuver_id = textOf("1");
  plan.maneuvers.value.data = {.present = true,
                               .value = {.control_src = 0x4001,
                                         .control_ent = kAnyEntity,
                                         .timeout = 15,
                                         .loiter_radius = 10,
                                         .altitude_interval = 0.5}};
  expectBytes("PlanControlStart", start);
}

/// That of the description: 1.2 m/s, 5 m deep.
TEST(ImcPackets, AReferenceIsWhatItsFieldsMake) {
  const auto from = arrived<Reference>("Reference", ByteOrder::Little);
  EXPECT_NEAR(from.lat, 0.7188, 1e-4);
  EXPECT_NEAR(from.lon, -0.1519, 1e-4);
  expectBytes("Reference",
              Reference{.flags = ReferenceFlag::Location | ReferenceFlag::Speed | ReferenceFlag::Z,
                        .speed = {true, {.value = 1.2, .speed_units = SpeedUnits::MetresPerSecond}},
                        .z = {true, {.value = 5, .z_units = ZUnits::Depth}},
                        .lat = from.lat,
                        .lon = from.lon,
                        .radius = 0});
}

}  // namespace
}  // namespace glider::hooks::imc
