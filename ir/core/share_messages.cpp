// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/share_messages.h"

#include "hooks/protocol/crc.h"
#include "hooks/share/message.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <span>
#include <string>

namespace glider::ir {
namespace {

constexpr uint32_t kSignatureMask = 0xFF;
static_assert(kMiniPacketBits == hooks::share::kMiniBits);

bool isAlike(const ShareMessage& one, const ShareMessage& other) {
  constexpr uint32_t kMini = hooks::share::MessageReader::kMiniSignatures;
  const bool minis = one.mini_bits != 0 && other.mini_bits != 0;
  return one.signature == other.signature ||
         (minis && one.signature % kMini == other.signature % kMini);
}

/// The same in every mission that shares the same, in any units.
std::string identityOf(const Mission& mission, const Share& share) {
  const auto bits = [](double number) { return std::bit_cast<uint64_t>(number); };
  const Type type = typeOf(mission, share);
  return fmt::format("{} {} {} {:016x} {:016x} {:016x} {:016x}\n", share.name,
                     static_cast<int>(type.kind), support::unitName(type.dimension),
                     bits(share.lowest), bits(share.step), bits(share.values),
                     bits(share.period_s));
}

/// Gives the last message a signature that none before it has: those of a mission are distinguished
/// by it.
void distinguish(std::vector<ShareMessage>& messages) {
  ShareMessage& last = messages.back();
  const auto minis = std::ranges::count_if(
      messages, [](const ShareMessage& message) { return message.mini_bits != 0; });
  if (minis > hooks::share::MessageReader::kMiniSignatures) {
    last.mini_bits = 0;
  }
  const auto taken = [&] {
    return std::any_of(messages.begin(), messages.end() - 1,
                       [&](const ShareMessage& other) { return isAlike(other, last); });
  };
  while (taken()) {  // there are fewer messages than signatures
    last.signature = (last.signature + 1) & kSignatureMask;
  }
}

}  // namespace

Type typeOf(const Mission& mission, const Share& share) {
  return share.sensor.index < mission.sensors.size()       ? mission[share.sensor].type
         : share.variable.index < mission.variables.size() ? mission[share.variable].type
                                                           : Type();  // it is damaged
}

ShareMessage messageOf(const Mission& mission, uint32_t first, uint32_t count) {
  std::vector<hooks::share::Scale> scales;
  uint32_t check = kHookCrc32cStart;
  for (const Share& share : std::span(mission.shares).subspan(first, count)) {
    scales.push_back({share.lowest, share.step, share.values});
    const std::string identity = identityOf(mission, share);
    check = hooks::crc32c(reinterpret_cast<const uint8_t*>(identity.data()),
                          static_cast<uint32_t>(identity.size()), check);
  }
  const hooks::share::MessageSize size = hooks::share::sizeOf(scales.data(), count);
  return {first, count, size.bytes, size.bits, size.mini_bits, check & kSignatureMask};
}

std::vector<ShareMessage> messagesOf(const Mission& mission) {
  std::vector<ShareMessage> messages;
  const std::span<const Share> shares = mission.shares;
  for (uint32_t first = 0; first < shares.size();) {
    uint32_t end = first + 1;
    while (end < shares.size() && shares[end].period_s == shares[first].period_s) {
      ++end;
    }
    messages.push_back(messageOf(mission, first, end - first));
    distinguish(messages);
    first = end;
  }
  return messages;
}

}  // namespace glider::ir
