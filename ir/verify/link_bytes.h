// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "platforms/load/platform.h"

#include <cstdint>

namespace glider::ir {

/// Bytes in one cycle of the vehicle, at most, by hooks/protocol/README.md: frames with all that
/// surrounds them. Each direction has the whole line.
struct LinkBytes {
  uint64_t to_sbc = 0;      ///< 115200 baud: the tick with every subscribed sensor
  uint64_t from_sbc = 0;    ///< the longest answer
  uint64_t to_science = 0;  ///< 9600 baud: all sensors of the flight controller
  uint64_t to_flight = 0;   ///< an instruction and a heartbeat
  uint64_t fast_line = 0;   ///< what each direction of the line of 115200 baud carries in a cycle
  uint64_t slow_line = 0;   ///< of that of 9600 baud
};

/// `platform` is the one that the mission names. Retries after lost frames are in the bound; what
/// opens a link is not, for nothing else is said then.
LinkBytes linkBytes(const Mission& mission, const platforms::Platform& platform);

}  // namespace glider::ir
