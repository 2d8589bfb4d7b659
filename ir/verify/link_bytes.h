// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "platforms/load/platform.h"

#include <cstdint>

namespace glider::ir {

/// Upper bounds of the bytes in one cycle of the vehicle, by hooks/protocol/README.md: frames with
/// all their overhead. Each direction has the whole line. (The line between the vehicle's own
/// computers is the vendor's.)
struct LinkBytes {
  uint64_t to_sbc = 0;     ///< 115200 baud: the tick with every subscribed sensor
  uint64_t from_sbc = 0;   ///< the longest answer
  uint64_t fast_line = 0;  ///< what each direction of the 115200-baud line carries in a cycle
};

/// `platform` is the one that the mission names. The bound includes retries after lost frames, but
/// not the opening of a link, because nothing else is sent then.
LinkBytes linkBytes(const Mission& mission, const platforms::Platform& platform);

}  // namespace glider::ir
