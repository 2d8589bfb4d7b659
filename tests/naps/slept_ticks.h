// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/eval/foresee.h"
#include "ir/eval/interpreter.h"

#include <optional>
#include <string>
#include <vector>

namespace glider::naps {

/// Watches the ticks of a flight that an SBC would sleep through, by what was foreseen before them.
/// Written from the meaning of ir/naps/wake.h alone.
class SleptTicks {
 public:
  /// `mission` outlives this.
  explicit SleptTicks(const ir::Mission& mission);

  /// After the start and after each tick, at `mission_time` (s): what the tick did although it
  /// would have been slept through, in words; empty: nothing.
  std::string after(const ir::Interpreter& interpreter, const ir::TickResult& now,
                    double mission_time);

  size_t slept = 0;   ///< ticks
  size_t woken = 0;   ///< ticks with a cause to wake
  size_t needed = 0;  ///< of these, how many did something else than the tick before

 private:
  [[nodiscard]] bool wakes(const ir::Interpreter& interpreter, double mission_time) const;
  void fallAsleep(const ir::Interpreter& interpreter, const ir::TickResult& now,
                  double mission_time);

  const ir::Mission& mission_;
  std::vector<ir::Wake> wakes_;  ///< of each state
  ir::TickResult before_;
  std::optional<ir::CommandRun> in_force_[2];  ///< vertical, lateral
  std::optional<ir::Foreseen> foreseen_;       ///< empty: awake
  std::vector<double> readings_;               ///< when it fell asleep
  double since_ = 0;
};

}  // namespace glider::naps
