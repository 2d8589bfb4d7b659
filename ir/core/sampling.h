// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/sampling.h"
#include "ir/core/mission.h"

#include <algorithm>
#include <vector>

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

/// What a state says of the instrument at `place`; null: nothing.
inline const Sampling* samplingOf(const State& state, uint32_t place) {
  const auto found = std::ranges::find(state.sampling, place, &Sampling::place);
  return found == state.sampling.end() ? nullptr : &*found;
}

/// Calls `visit` with each code that may be in force: a constant, or what the mission computes from
/// Sampling::period. What replaces a code while it is unknown is not one if `isKnown` of it.
template <typename IsKnown, typename Visit>
void forEachCode(const Mission& mission, const Sampling& sampling, IsKnown isKnown, Visit visit) {
  std::vector<ExprId> open{sampling.code};
  while (!open.empty()) {
    const Expr& e = mission[open.back()];
    open.pop_back();
    if (e.op != Op::Select) {
      visit(e);
      continue;
    }
    const Expr& condition = mission[e.operands[0]];
    open.push_back(e.operands[1]);
    if (condition.op != Op::Known || !isKnown(condition.operands[0])) {
      open.push_back(e.operands[2]);
    }
  }
}

/// What the code of an instrument at `place` is multiplied by in the word.
inline double samplingWeight(uint32_t place) {
  return static_cast<double>(1U << (place * kHookSamplingBits));
}

}  // namespace glider::ir
