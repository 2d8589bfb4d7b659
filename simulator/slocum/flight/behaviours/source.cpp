// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/flight/behaviours/source.h"

#include "vehicles/slocum/mission_files/behaviour_catalogue.h"

namespace glider::simulator {
namespace {

/// The value of a b_arg that not every behaviour has.
double valueOr(const slocum::BehaviourBlock& block, std::string_view name, double otherwise) {
  const slocum::KnownBehaviour* known = slocum::findBehaviour(block.name);
  return known != nullptr && known->find(name) != nullptr ? block.value(name) : otherwise;
}

}  // namespace

WhenCondition BehaviourSource::condition(const std::string& name, bool stops) const {
  return {code(name),
          {.secs = {valueOr(block, "when_secs", 0), variables},
           .distance_m = {valueOr(block, "when_wpt_dist", 0), variables},
           .utc_stamp = valueOr(block, "when_utc_timestamp", -1),
           .inflections = valueOr(block, "when_num_inflections", -1)},
          code_15,
          stops};
}

WhenCondition BehaviourSource::startCondition() const {
  return condition("start_when", false);
}

WhenCondition BehaviourSource::stopCondition() const {
  return condition("stop_when", true);
}

PitchSource BehaviourSource::pitch(const std::string& prefix) const {
  const int use = code(prefix + "use_pitch");
  const auto mode = use == 1   ? PitchCommand::Mode::BatteryPosition
                    : use == 2 ? PitchCommand::Mode::Curve
                               : PitchCommand::Mode::Servo;
  return {mode, argument(prefix + "pitch_value")};
}

Argument BehaviourSource::pump(const std::string& prefix, Pumps pumps) const {
  constexpr int kAutoballast = 0, kSpeed = 5;
  constexpr double kFull = 1000;  // cc, beyond every pump: it moves to its limit
  const int use = code(prefix + "use_bpump");
  // bpump_value is then the whole stroke of the yo, or a speed: its sign says nothing.
  return use == kAutoballast || use == kSpeed
             ? Argument(pumps == Pumps::Out ? kFull : -kFull, variables)
             : argument(prefix + "bpump_value");
}

}  // namespace glider::simulator
