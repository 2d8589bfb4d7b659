// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/imc/codec.h"
#include "hooks/protocol/instruction.h"
#include "runtime/abi/imc_mission.h"
#include "runtime/front_seat/position.h"

namespace glider::runtime::imc {

/// Makes the vehicle's References from instructions. A Reference has a place, a speed and a depth,
/// and no heading: a heading is a place far ahead (README.md, rules M6 to M8).
class Course {
 public:
  explicit Course(const GliderImcMission& mission) : mission_(mission) {}

  /// A new command. `here`: where the vehicle is; `heading`: rad, for a command that keeps it.
  void steer(const hooks::Instruction& command, const Place& here, double heading);
  /// At the surface, where it is: until the first command and after the last.
  void surface() { has_command_ = false; }
  /// What it is given now. False if its place is not known.
  [[nodiscard]] bool reference(const Place& here, hooks::imc::Reference& reference);

  /// How far ahead the place of a heading is, and how near it may come, m.
  static constexpr double kAhead_m = 2000;
  static constexpr double kNear_m = 500;
  /// A fixed place is given again, as another one, when the vehicle is so near; as it was, when it
  /// is so far again, or beyond kArrived_m when the depth changes, m (README.md, rule M7).
  static constexpr double kArrived_m = 14;
  static constexpr double kLeft_m = 20;

 private:
  void aimAhead(const Place& here);
  void lookWhetherItArrives(const Place& here);
  [[nodiscard]] bool isAhead(const Place& here) const;

  GliderImcMission mission_;
  hooks::Instruction command_;
  bool has_command_ = false;
  double heading_ = __builtin_nan("");  ///< of a place that is far ahead; NaN: the place is fixed
  Place aim_;
  bool arrived_ = false;  ///< at a fixed place
};

}  // namespace glider::runtime::imc
