// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/campaign/pump_judge.h"

#include "simulator/campaign/judge_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::simulator {

std::string PumpJudge::cycle(const CycleView& view) {
  constexpr double kAnHour = 3600;  // s
  const double step_s = view.time_s - last_s_;
  const double moved_cc = std::isnan(pumped_cc_) ? 0 : std::fabs(view.pumped_cc - pumped_cc_);
  // The SBC may be off: what all loads draw at most is not the pump's.
  const double pump_J = std::max(0.0, view.used_J - used_J_ - s_.loads_W * step_s);
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

}  // namespace glider::simulator
