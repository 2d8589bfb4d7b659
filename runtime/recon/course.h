// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/instruction.h"
#include "runtime/abi/recon_mission.h"
#include "runtime/front_seat/position.h"

namespace glider::runtime::recon {

/// What the vehicle is given: always all three (README.md, N7).
struct Goals {
  double heading_deg = 0;
  double speed_m_s = 0;
  double depth_m = 0;
};

/// Makes the vehicle's goals from instructions (README.md, rules N7 to N9).
class Course {
 public:
  explicit Course(const GliderReconMission& mission) : mission_(mission) {}

  /// A new command. `heading`: the vehicle's, rad, for a command that keeps it.
  void steer(const hooks::Instruction& command, double heading);
  /// To the surface: until the first command and after the last.
  void surface() { has_command_ = false; }
  /// What it is given now. `heading`: the vehicle's, rad. False if no heading is known.
  [[nodiscard]] bool goals(const Place& here, double heading, Goals& goals) const;

 private:
  [[nodiscard]] double headingNow(const Place& here, double heading) const;

  GliderReconMission mission_;
  hooks::Instruction command_;
  bool has_command_ = false;
  double kept_heading_ = __builtin_nan("");  ///< of a command that drifts
};

}  // namespace glider::runtime::recon
