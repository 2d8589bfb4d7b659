// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/abstract/timer_guards.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace glider::ir::prove {

/// A variable of a mission that holds when something last happened: `var talked: time = 0 s`, to
/// which nothing is assigned but `missiontime`, in a case's `do`. It starts at 0 or before, so it
/// is never unknown, and never after the mission time.
///
/// After each tick that leaves a state current, but the one on which it became current, its own
/// case was tried, and that of `always` unless the state keeps it from firing; or a case fired
/// before it that does so only at the surface.
struct Timer {
  VariableId since;
  TimerCase always;
  std::vector<bool> kept;             ///< states that may keep that of `always` from firing
  std::vector<TimerCase> own;         ///< of each state
  std::vector<bool> set_under_water;  ///< states during which it may be set under water

  /// The longest that the mission time may be after `since`, s, if it was so tried.
  [[nodiscard]] double longest(uint32_t state) const {
    return std::min(own[state].longest, ofAlways(state).longest);
  }
  /// Whether a case of any list is known.
  [[nodiscard]] bool bounds() const {
    const auto is = [](const TimerCase& c) { return std::isfinite(c.longest); };
    return is(always) || std::ranges::any_of(own, is);
  }
  [[nodiscard]] TimerCase ofAlways(uint32_t state) const {
    return kept[state] ? TimerCase{} : always;
  }
};

/// The timers that bound something, of a mission that has ended by `ends_by` (mission time, s;
/// infinite if that is not known). `may_fire_under_water` says of a guard whether it may be true
/// while the vehicle is under water.
std::vector<Timer> timersOf(const ProofContext& proof_context, const Valuation& values,
                            double ends_by,
                            const std::function<bool(ExprId)>& may_fire_under_water);

}  // namespace glider::ir::prove
