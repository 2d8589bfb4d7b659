// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <cstdint>
#include <vector>

namespace glider::ir {

/// The shares of one period, which are sent in one message of the modem.
struct ShareMessage {
  uint32_t first = 0;  ///< in Mission::shares
  uint32_t count = 0;
  uint32_t bytes = 0;      ///< of the packed message; 0: more than a frame of the modem holds
  uint32_t bits = 0;       ///< that it needs, with the signature; 0 if `bytes` is
  uint32_t mini_bits = 0;  ///< as a mini packet of the modem; 0: it is sent in a frame
  uint32_t signature = 0;  ///< 0..255: of the names, scales and period of its shares
};

/// A mini packet of the modem holds so many bits.
inline constexpr uint32_t kMiniPacketBits = 13;

/// What a share sends: the type of its sensor or variable.
Type typeOf(const Mission& mission, const Share& share);

/// The message of these shares of one period, of which number `first` is the first.
ShareMessage messageOf(const Mission& mission, uint32_t first, uint32_t count);

/// The messages of a mission, shortest period first.
std::vector<ShareMessage> messagesOf(const Mission& mission);

}  // namespace glider::ir
