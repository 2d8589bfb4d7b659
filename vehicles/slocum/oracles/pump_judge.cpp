// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/oracles/pump_judge.h"

#include "vehicles/slocum/oracles/judge_limits.h"
#include "vehicles/slocum/oracles/wrong_sensors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::slocum::oracles {

/// True if the pump may still follow an instruction of a mission whose sensors are wrong.
bool PumpJudge::isMisled(const CycleView& view, const hooks::Instruction& in_force) {
  constexpr double kFollowsSecs = 40;  // for a stroke of the pump, and a cycle or two
  const bool same =
      in_force.vertical == in_force_.vertical && in_force.depth_m == in_force_.depth_m;
  instructed_s_ = same ? instructed_s_ : view.time_s;
  in_force_ = in_force;
  return anyWrong(s_.faults, view.time_s, kFollowsSecs) &&
         view.time_s - instructed_s_ <= kFollowsSecs;
}

std::string PumpJudge::cycle(const CycleView& view, const hooks::Instruction& in_force) {
  constexpr double kAnHour = 3600;  // s
  const double step_s = view.time_s - last_s_;
  const bool counts = !isMisled(view, in_force) && !std::isnan(pumped_cc_);
  const double moved_cc = counts ? std::fabs(view.pumped_cc - pumped_cc_) : 0;
  // The SBC may be off: what all loads draw at most is not the pump's.
  const double pump_J = counts ? std::max(0.0, view.used_J - used_J_ - s_.loads_W * step_s) : 0;
  last_s_ = view.time_s;
  pumped_cc_ = view.pumped_cc;
  used_J_ = view.used_J;
  const double stroke_cc = 2 * s_.pump_cc;
  strokes_ = std::max(0.0, strokes_ + (stroke_cc > 0 ? moved_cc / stroke_cc : 0) -
                               limits::kStrokesAnHour * step_s / kAnHour);
  more_J_ = std::max(0.0, more_J_ + pump_J - limits::kPumpW * step_s);
  if (strokes_ > limits::kStrokesMore) {
    return fmt::format("the pump has made {:.0f} strokes more than {} an hour", strokes_,
                       limits::kStrokesAnHour);
  }
  return more_J_ > limits::kPumpMoreJ
             ? fmt::format("the pump has taken {:.0f} J more than {} W", more_J_, limits::kPumpW)
             : "";
}

}  // namespace glider::slocum::oracles
