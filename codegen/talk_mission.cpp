// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/talk_mission.h"

#include "ir/core/share_messages.h"
#include "platforms/load/modem.h"
#include "support/check.h"

namespace glider::codegen {
namespace {

static_assert(ir::kMostReadings == GLIDER_MOST_NAMED && ir::kMostShares == GLIDER_MOST_SHARES);

constexpr auto kBeginWithinMs = static_cast<uint32_t>(platforms::kSlowestCycle_s * 1000);

template <typename Id>
uint32_t placeOf(Id id) {
  return id.valid() ? id.index : GLIDER_NO_PLACE;
}

}  // namespace

bool talks(const ir::Mission& mission) {
  return !mission.shares.empty();
}

GliderTalk talkMissionOf(const ir::Mission& mission, const platforms::Platform& platform) {
  CHECK(talks(mission) && mission.shares.size() <= GLIDER_MOST_SHARES, "shares that do not fit");
  GliderTalk talk{};
  CHECK(platform.modem.has_value(), "a mission with shares for a vehicle without a modem");
  talk.slot_s = platforms::slotOf(*platform.modem, platform.envelope.cycle_s);
  talk.begin_within_ms = kBeginWithinMs;
  talk.utc = mission.utc.index;
  talk.vehicle_count = static_cast<uint32_t>(mission.vehicles.size());
  for (const ir::Share& share : mission.shares) {
    for (const ir::FromVehicle& from : share.named) {
      CHECK(talk.named_count < GLIDER_MOST_NAMED, "more values are received than a frame holds");
      talk.named[talk.named_count++] = {from.sensor.index, static_cast<uint16_t>(talk.share_count),
                                        static_cast<uint16_t>(from.address)};
    }
    talk.shares[talk.share_count++] = {share.lowest,
                                       share.step,
                                       share.values,
                                       placeOf(share.sensor),
                                       placeOf(share.variable),
                                       placeOf(share.peer)};
  }
  for (const ir::ShareMessage& message : ir::messagesOf(mission)) {
    talk.messages[talk.message_count++] = {
        mission.shares[message.first].period_s, message.first, message.count, message.signature,
        message.mini_bits != 0 ? GLIDER_MINI_PACKET : message.bytes};
  }
  return talk;
}

}  // namespace glider::codegen
