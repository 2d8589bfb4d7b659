// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/oracles/ascent_judge.h"

#include <fmt/format.h>

namespace glider::slocum::oracles {

using hooks::HookState;

std::string AscentJudge::cycle(const CycleView& view) {
  constexpr double kAtSurface = 1;  // m
  const double gap_s = view.time_s - last_s_;
  last_s_ = view.time_s;
  const bool dives = !view.aborted && (view.hook == HookState::Active || !s_.only_hookbeh);
  if (dives || view.true_depth_m < kAtSurface) {
    up_by_s_ = -1;
    return "";
  }
  if (up_by_s_ < 0) {
    up_by_s_ = view.time_s + s_.turn_s + view.true_depth_m / s_.slowest_climb_mps;
  } else if (s_.isDark(gap_s)) {
    up_by_s_ += gap_s;  // the flight controller did nothing meanwhile
  }
  return view.time_s <= up_by_s_
             ? ""
             : fmt::format("still {:.1f} m deep though nothing dives any more", view.true_depth_m);
}

}  // namespace glider::slocum::oracles
