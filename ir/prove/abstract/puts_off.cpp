// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/puts_off.h"

#include "ir/prove/abstract/bounds_by_state.h"
#include "ir/verify/intervals.h"

#include <algorithm>

namespace glider::ir::prove {

PutsOff::PutsOff(const ProofContext& proof_context)
    : mission_(proof_context.mission),
      values_(anyValues(mission_)),
      next_tick_(proof_context, values_,
                 {Interval{0, kGreatestNumber, false}, Interval{0, kGreatestNumber, false},
                  Interval{0, proof_context.tick_gap_s, false}}) {}

const Case* PutsOff::by(StateId state) const {
  const std::vector<Case>& cases = mission_[state].cases;
  const auto found = std::ranges::find_if(cases, [&](const Case& c) { return mayFire(c); });
  return found == cases.end() ? nullptr : &*found;
}

bool PutsOff::again(const Control& control) const {
  const auto returns = [&](const Case& c) {
    return c.transition == Transition::Return && mayFire(c);
  };
  return control.just_returned && !control.stack.empty() &&
         std::ranges::any_of(mission_[control.state].cases, returns);
}

}  // namespace glider::ir::prove
