// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/slocum/flight/behaviour.h"
#include "simulator/slocum/flight/behaviours/source.h"

#include <limits>

namespace glider::simulator {

/// nop_cmds: keeps command slots busy without moving a motor, for secs_to_run.
class NopCommands final : public Behaviour {
 public:
  explicit NopCommands(const BehaviourSource& source)
      : Behaviour(source.block.name),
        pitch_(source.code("nop_pitch") != 0),
        pump_(source.code("nop_bpump") != 0),
        heading_(source.code("nop_heading") != 0),
        runs_s_(source.argument("secs_to_run")) {}
  /// It keeps the mission going, as on the vehicle.
  [[nodiscard]] bool flies() const override { return true; }

 protected:
  [[nodiscard]] bool starts(const Situation&, const Commands&) const override { return true; }
  void begin(const Situation& s) override { begun_s_ = s.time_s; }
  Outcome fly(const Situation& s, Commands& commands) override {
    if (runs_s_() >= 0 && s.time_s - begun_s_ >= runs_s_()) {
      return Outcome::Done;
    }
    if (heading_ && !commands.heading) {
      commands.steer({HeadingCommand::Mode::Ignore, 0, 0, 0});
    }
    if (pitch_ && !commands.pitch) {
      commands.point({PitchCommand::Mode::Ignore, 0});
    }
    if (pump_ && !commands.pump_cc) {
      commands.pump(std::numeric_limits<double>::quiet_NaN());
    }
    return Outcome::Continue;
  }

 private:
  bool pitch_, pump_, heading_;
  Argument runs_s_;
  double begun_s_ = 0;
};

}  // namespace glider::simulator
