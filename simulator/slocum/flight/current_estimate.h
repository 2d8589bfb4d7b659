// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/geography/planar.h"

#include <cstdint>
#include <optional>

namespace glider::simulator {

/// The depth-averaged current as the vehicle estimates it: by how far the first fix of a surfacing
/// is from the dead-reckoned position, less the drift at the surface until that fix, which a second
/// fix shows, over the time under water.
class CurrentEstimate {
 public:
  /// x_dr_state.
  enum class State : uint8_t {
    MissionStart,
    UnderWater,
    AwaitingFix,
    AwaitingPostfix,
    AwaitingDive
  };

  /// One control cycle at `time_s`. `reckoned`: the position by dead reckoning, before `fix` (a new
  /// fix, if there is one) corrects it. `used`: the current that the reckoning included.
  void observe(double time_s, bool at_surface, Planar reckoned, std::optional<Planar> fix,
               Planar used);

  [[nodiscard]] State state() const { return state_; }
  /// The newest estimate; empty before the first.
  [[nodiscard]] const std::optional<Planar>& current() const { return current_; }

 private:
  void dive(double time_s);
  void surface(double time_s, Planar reckoned);
  void estimate(Planar surfaced_at);

  State state_ = State::MissionStart;
  double dived_s_ = 0, surfaced_s_ = 0, fixed_s_ = 0;
  Planar reckoned_, used_, fixed_at_;
  std::optional<Planar> current_;
};

}  // namespace glider::simulator
