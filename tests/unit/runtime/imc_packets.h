// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/imc/codec.h"
#include "hooks/imc/packet_reader.h"
#include "hooks/imc/values.h"
#include "runtime/abi/imc_mission.h"
#include "runtime/imc/plan.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

/// Packets of a vehicle that is steered by IMC, for the tests of the back seat's parts.
namespace glider::runtime::testing {

inline constexpr uint16_t kVehicleAddress = 0x1E;
inline constexpr double kDegree = 3.14159265358979323846 / 180;

/// Limits like those of platforms/lauv.toml; no readings.
inline constexpr GliderImcMission kImcLimits{.greatest_depth_m = 50,
                                             .slowest_m_s = 0.7,
                                             .fastest_m_s = 1.6,
                                             .usual_m_s = 1.2,
                                             .timeout_s = 15,
                                             .loiter_m = 10,
                                             .start_depth_m = 2,
                                             .vehicle = 0,
                                             .count = 0,
                                             .sensors = {},
                                             .sources = {}};

template <typename Message>
std::vector<uint8_t> packetBytes(const Message& message, double time_s,
                                 uint16_t source = kVehicleAddress,
                                 uint16_t destination = hooks::imc::kAllSystems) {
  std::vector<uint8_t> bytes(hooks::imc::kMostPacket);
  const hooks::imc::Header header{.time_s = time_s,
                                  .source = source,
                                  .source_entity = 1,
                                  .destination = destination,
                                  .destination_entity = hooks::imc::kAnyEntity};
  bytes.resize(encode(header, message, bytes.data(), static_cast<uint32_t>(bytes.size())));
  EXPECT_FALSE(bytes.empty());
  return bytes;
}

/// Gives a message to `taker` as a packet of the vehicle.
template <typename Message, typename Taker>
void give(const Message& message, double time_s, Taker& taker) {
  const std::vector<uint8_t> bytes = packetBytes(message, time_s);
  hooks::imc::PacketReader reader;
  ASSERT_EQ(reader.push(bytes.data(), static_cast<uint32_t>(bytes.size())), bytes.size());
  hooks::imc::Packet packet;
  ASSERT_TRUE(reader.next(&packet));
  taker.take(packet);
}

inline hooks::imc::PlanControlState planState(uint8_t state, const char* plan = "glidercc") {
  hooks::imc::PlanControlState said;
  said.state = state;
  said.plan_id = hooks::imc::textOf(plan);
  return said;
}

inline hooks::imc::FollowRefState followState(uint8_t state,
                                              uint16_t of = runtime::imc::kOwnAddress) {
  hooks::imc::FollowRefState said;
  said.control_src = of;
  said.control_ent = hooks::imc::kAnyEntity;
  said.state = state;
  return said;
}

}  // namespace glider::runtime::testing
