// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/acoustics/liar.h"

#include <cstdint>
#include <map>

namespace glider::simulator {

/// What disturbs the messages of a fleet in a flight, beyond the water and the distance. Noise is a
/// fault of each vehicle's scenario.
struct AcousticTrouble {
  double loss = 0;                 ///< probability that a receiver loses a frame for this reason
  std::map<uint32_t, Liar> liars;  ///< what these vehicles send is replaced, by number
};

}  // namespace glider::simulator
