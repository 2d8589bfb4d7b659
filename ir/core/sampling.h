// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/sampling.h"
#include "ir/core/mission.h"

#include <algorithm>

namespace glider::ir {

/// Whether any state says how often an instrument reads: then each state commands it, when it
/// becomes current.
inline bool samples(const Mission& mission) {
  return std::ranges::any_of(mission.states, [](const State& s) { return !s.sampling.empty(); });
}

/// Whether what a state says of it may change while it is current: then each tick commands it.
inline bool samplingChanges(const Mission& mission, const State& state) {
  return std::ranges::any_of(
      state.sampling, [&](const Sampling& one) { return mission[one.code].op != Op::Constant; });
}

/// What the code of an instrument at `place` is multiplied by in the word.
inline double samplingWeight(uint32_t place) {
  return static_cast<double>(1U << (place * kHookSamplingBits));
}

}  // namespace glider::ir
