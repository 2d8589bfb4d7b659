// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/core/truth.h"

#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace glider::ir {

/// One reading of a frame: what the vehicle reported, in its own unit.
struct SensorUpdate {
  SensorId sensor;
  double raw = 0;
};

/// Why a behaviour runs.
enum class Phase : uint8_t { Enter, Resume, Tick };

/// A state that waits for a return, and the mission time (s) at which it was entered.
struct Frame {
  StateId state;
  double entered = 0;
};

/// A run of a profile or route with the arguments it was given, SI units (positions: degrees); NaN:
/// unknown.
struct ActivityRun {
  BehaviourId behaviour;
  Phase phase = Phase::Tick;
  std::vector<double> arguments;
};

/// What a tick did.
struct TickResult {
  StateId state;                       ///< current after the tick
  bool finished = false;               ///< an `exit` has fired in this tick or earlier
  std::optional<uint32_t> fired_case;  ///< of the state that was current before; empty if none
  std::vector<Frame> stack;            ///< outermost first
  std::optional<ActivityRun> profile;  ///< both empty once finished
  std::optional<ActivityRun> route;
};

/// A number (NaN: unknown, always the same NaN) or a truth value.
using Value = std::variant<double, Truth>;

/// Runs a mission as ir/README.md says, for obviousness and not for speed: the judge of generated
/// code.
class Interpreter {
 public:
  /// `mission` must be valid, free of verification errors, and outlive this; `stack_depth` is
  /// MissionFacts'. A call deeper than that, or a return without a caller, is our own bug and ends
  /// the program.
  Interpreter(const Mission& mission, uint32_t stack_depth);

  /// The tick at mission time 0 that enters the first state, with the readings of its frame. Once,
  /// before any `tick`.
  TickResult start(std::span<const SensorUpdate> frame = {});
  /// A tick at `mission_time` (s, finite; one smaller than before counts as the one before). A
  /// sensor that the frame holds twice keeps the later value.
  TickResult tick(double mission_time, std::span<const SensorUpdate> frame);
  /// The value of an expression after the latest tick, in the state that it left current.
  [[nodiscard]] Value evaluate(ExprId id) const { return values_.at(id.index); }
  /// The same for one that is known to be a number (a log item, an argument) or a truth value (a
  /// guard).
  [[nodiscard]] double number(ExprId id) const { return std::get<double>(evaluate(id)); }
  [[nodiscard]] Truth truthOf(ExprId id) const { return std::get<Truth>(evaluate(id)); }
  /// This tick's reading of a sensor, SI units; NaN: unknown.
  [[nodiscard]] double readingOf(SensorId id) const { return sensors_.at(id.index).value; }

 private:
  struct SensorState {
    double raw = 0;
    double updated = 0;  ///< mission time of its newest frame; 0 if none
    bool seen = false;
    double value = 0;
  };

  void take(double mission_time, std::span<const SensorUpdate> frame);
  void evaluateAll();
  [[nodiscard]] Value valueOf(const Expr& expr) const;
  [[nodiscard]] double age(SensorId id) const;
  [[nodiscard]] std::optional<uint32_t> firstTrueCase() const;
  Phase fire(const Case& fired);
  [[nodiscard]] ActivityRun run(const Activity& activity, Phase phase) const;
  [[nodiscard]] TickResult result(std::optional<uint32_t> fired, Phase phase) const;

  const Mission& mission_;
  uint32_t stack_depth_;
  std::vector<SensorState> sensors_;
  std::vector<Value> values_;  ///< of every expression, now
  std::vector<Frame> stack_;
  StateId state_{0};
  double mission_time_ = 0;
  double entered_ = 0;
  double resumed_ = 0;
  bool started_ = false;
  bool finished_ = false;
};

}  // namespace glider::ir
