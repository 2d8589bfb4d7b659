// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/naps/slept_ticks.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <sstream>

namespace glider::naps {
namespace {

bool sameNumbers(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(
      a, b, [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

/// Calls of profiles in C: what they command is not known, and no SBC sleeps.
bool inC(const ir::TickResult& now) {
  return std::ranges::any_of(now.actions, [](const ir::Action& action) {
    return std::holds_alternative<ir::ActivityRun>(action);
  });
}

bool isLateral(ir::Command command) {
  return command == ir::Command::Steer || command == ir::Command::SteerTo ||
         command == ir::Command::Drift || command == ir::Command::Fin;
}

/// Whether the tick changes a command in force, and then which commands are.
bool takesIn(const ir::TickResult& now, std::optional<ir::CommandRun> (&in_force)[2]) {
  const auto before = std::to_array(in_force);
  for (const ir::Action& action : now.actions) {
    const auto& run = std::get<ir::CommandRun>(action);
    if (!run.refused) {
      in_force[isLateral(run.command) ? 1 : 0] = run;
    }
  }
  return !std::ranges::equal(before, in_force, [](const auto& x, const auto& y) {
    return x.has_value() == y.has_value() &&
           (!x || (x->command == y->command && sameNumbers(x->arguments, y->arguments)));
  });
}

/// What `now` did otherwise than `before`; empty: nothing.
std::string difference(const ir::TickResult& before, const ir::TickResult& now, bool commands) {
  if (now.finished || now.moved || now.state != before.state) {
    return "a transition";
  }
  if (now.fired != before.fired) {
    return "another case";
  }
  if (!now.notes.empty() || now.lost_notes != 0) {
    return "a note";
  }
  if (commands) {
    return "another command";
  }
  if (!sameNumbers(before.variables, now.variables)) {
    return "a variable";
  }
  return before.sampling == now.sampling ? "" : "other instruments";
}

bool crossed(double before, double now, double number) {
  if (std::isnan(before)) {
    return !std::isnan(now);
  }
  return before < number ? now >= number : before > number ? now <= number : now != before;
}

}  // namespace

SleptTicks::SleptTicks(const ir::Mission& mission) : mission_(mission) {
  for (uint32_t i = 0; i < mission.states.size(); ++i) {
    wakes_.push_back(ir::wakeOf(mission, ir::StateId{i}));
  }
}

bool SleptTicks::wakes(const ir::Interpreter& interpreter, double mission_time) const {
  if (mission_time - since_ >= std::floor(foreseen_->seconds)) {
    return true;
  }
  return std::ranges::any_of(foreseen_->causes, [&](const ir::Foreseen::Cause& cause) {
    const double before = readings_.at(cause.sensor.index);
    const double now = interpreter.readingOf(cause.sensor);
    if (cause.kind == ir::WakeKind::Crossed) {
      return crossed(before, now, cause.number);
    }
    return cause.kind == ir::WakeKind::Known ? std::isnan(before) && !std::isnan(now)
                                             : !std::isnan(before) && std::isnan(now);
  });
}

void SleptTicks::fallAsleep(const ir::Interpreter& interpreter, const ir::TickResult& now,
                            double mission_time) {
  foreseen_.reset();
  const bool as_before = sameNumbers(before_.variables, now.variables) && !before_.moved;
  if (!as_before || now.moved || !now.notes.empty() || now.finished) {
    return;
  }
  ir::Foreseen found = ir::foresee(interpreter, wakes_.at(now.state.index), now);
  if (found.awake) {
    return;
  }
  foreseen_ = std::move(found);
  since_ = mission_time;
  readings_.clear();
  for (uint32_t i = 0; i < mission_.sensors.size(); ++i) {
    readings_.push_back(interpreter.readingOf({i}));
  }
}

std::string SleptTicks::after(const ir::Interpreter& interpreter, const ir::TickResult& now,
                              double mission_time) {
  std::string wrong;
  const bool commands = !inC(now) && takesIn(now, in_force_);
  const std::string differs = difference(before_, now, commands);
  const bool sleeps = foreseen_.has_value();
  const bool wakes_up = sleeps && wakes(interpreter, mission_time);
  if (sleeps && !wakes_up) {
    ++slept;
    wrong = differs;
  } else if (wakes_up) {
    ++woken;
    needed += differs.empty() ? 0U : 1U;
  }
  if (!sleeps || wakes_up) {
    fallAsleep(interpreter, now, mission_time);
  }
  before_ = now;
  return wrong;
}

}  // namespace glider::naps
