// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/hull.h"
#include "simulator/slocum/flight/mission_variables.h"
#include "simulator/slocum/flight/when.h"
#include "vehicles/slocum/mission_files/mission_file.h"

#include <cstdint>
#include <string>

namespace glider::simulator {

/// use_pitch and pitch_value of a behaviour: 1 battery position, 2 calibration curve, 3 servo.
struct PitchSource {
  PitchCommand::Mode mode;
  Argument value;

  [[nodiscard]] PitchCommand now() const { return {mode, value()}; }
};

/// What a behaviour is made from: its block of the mission file, which has passed checkSkeleton,
/// and what else it depends on.
struct BehaviourSource {
  const slocum::BehaviourBlock& block;
  const hooks::Hull& hull;
  const MissionVariables& variables;
  Code15 code_15 = Code15::FarFromWaypoint;

  [[nodiscard]] Argument argument(const std::string& name) const {
    return {block.value(name), variables};
  }
  /// A b_arg that is an enumerated code, a flag or a count.
  [[nodiscard]] int code(const std::string& name) const {
    return static_cast<int>(block.value(name));
  }
  /// start_when with the b_args that it may need.
  [[nodiscard]] WhenCondition startCondition() const;
  /// stop_when, likewise.
  [[nodiscard]] WhenCondition stopCondition() const;
  /// use_pitch and pitch_value behind `prefix` ("d_", "c_", "").
  [[nodiscard]] PitchSource pitch(const std::string& prefix) const;
  /// The pump's volume behind `prefix`, cc: bpump_value, or all of it, out or in, where the vehicle
  /// controls its ballast or speed itself.
  enum class Pumps : uint8_t { In, Out };
  [[nodiscard]] Argument pump(const std::string& prefix, Pumps pumps) const;

 private:
  [[nodiscard]] WhenCondition condition(const std::string& name, bool stops) const;
};

}  // namespace glider::simulator
