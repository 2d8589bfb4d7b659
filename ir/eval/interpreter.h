// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/core/ops.h"
#include "ir/core/truth.h"
#include "ir/eval/evaluate.h"
#include "ir/eval/leg_window.h"
#include "ir/eval/tick_result.h"
#include "ir/eval/window.h"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace glider::ir {

/// One reading of a frame: what the vehicle reported, in its own unit.
struct SensorUpdate {
  SensorId sensor;
  double raw = 0;
};

/// The C code that is linked to a mission, by its symbol; what is missing gives unknown.
struct Externals {
  /// The result of the function for these arguments: any double.
  std::function<double(const Function&, std::span<const double> arguments)> call;
  /// A new reading of one of the SBC's own sensors at that mission time (s); NaN: there is none.
  std::function<double(const Sensor&, double mission_time)> poll;
};

/// The values that the parameters of `mission` have unless they are set.
std::vector<double> defaultParameters(const Mission& mission);

/// The first of `mission`'s conditions that these values of its parameters do not satisfy, or that
/// is unknown; empty if all hold.
std::optional<uint32_t> failedCondition(const Mission& mission, std::span<const double> parameters);

/// Runs a mission as ir/README.md defines it. Written to be obviously correct, not fast: the
/// reference for generated code.
class Interpreter {
 public:
  /// `mission` must be valid, free of verification errors, and outlive this; `stack_depth` is that
  /// of MissionFacts. What verification rules out (a call deeper than that, a return without a
  /// caller, a variable that leaves its range) is a bug of glidercc and ends the program.
  Interpreter(const Mission& mission, uint32_t stack_depth, Externals externals = {});

  /// The tick at mission time 0 that enters the first state, with the readings of its frame and
  /// one value, within its range, for each parameter (SI units, degrees; a truth value 0 or 1).
  /// Once, before any `tick`.
  TickResult start(std::span<const SensorUpdate> frame, std::span<const double> parameters);
  /// The same with the parameters' defaults.
  TickResult start(std::span<const SensorUpdate> frame = {});
  /// The same, but enters `state` with these values of its parameters instead of the mission's
  /// first state: for analyses of one state.
  TickResult startIn(StateId state, std::span<const double> arguments,
                     std::span<const SensorUpdate> frame, std::span<const double> parameters);
  /// A tick at `mission_time` (s, finite; a smaller time than before counts as the time before). If
  /// the frame holds a sensor twice, the later value is used.
  TickResult tick(double mission_time, std::span<const SensorUpdate> frame);
  /// The two halves of a tick. `advance` makes steps 1 to 3: then `evaluate` gives the guards
  /// before any case of this tick has fired. `decide` makes the others. After the mission has
  /// finished, `advance` does nothing.
  void advance(double mission_time, std::span<const SensorUpdate> frame);
  TickResult decide();
  /// The value of an expression now, after the latest tick, in the state that the tick left
  /// current.
  [[nodiscard]] Value evaluate(ExprId id) const;
  /// The same for one that is known to be a number (a log item, an argument) or a truth value (a
  /// guard).
  [[nodiscard]] double number(ExprId id) const { return std::get<double>(evaluate(id)); }
  [[nodiscard]] Truth truthOf(ExprId id) const { return std::get<Truth>(evaluate(id)); }
  /// This tick's reading of a sensor, SI units; NaN: unknown.
  [[nodiscard]] double readingOf(SensorId id) const { return sensors_.at(id.index).value; }
  /// Whether a case of `always` is true now and would not be tried: because of the case that led
  /// here (L3), or because its target is in use (L1).
  [[nodiscard]] bool isHeldBack(uint32_t always_case) const;
  /// What a variable holds; NaN: unknown.
  [[nodiscard]] double value(VariableId id) const { return variables_.at(id.index); }

 private:
  struct SensorState {
    double raw = 0;
    double updated = 0;  ///< mission time of its newest frame; 0 if none
    bool seen = false;
    double value = 0;
  };
  struct TemporalState {
    bool was_true = false;  ///< the operand, when this last advanced or started
    double since = 0;
    Value value = Truth::Unknown;
    std::optional<PlainWindow> window;  ///< of a window over a time or a stretch
    std::optional<PlainLegs> legs;      ///< of a window over a leg
  };
  enum class TemporalMoment : uint8_t { Start, Resume, Advance };

  void begin(std::span<const SensorUpdate> frame, std::span<const double> parameters);
  void take(double mission_time, std::span<const SensorUpdate> frame);
  void poll();
  [[nodiscard]] Value leaf(const Expr& expr, std::span<const double> arguments) const;
  [[nodiscard]] double called(UseId use, std::span<const double> arguments) const;
  [[nodiscard]] double clock(ClockOp op) const;
  [[nodiscard]] double age(SensorId id) const;

  [[nodiscard]] bool current(const Temporal& temporal) const;
  void startTemporals(bool always, TemporalMoment moment);
  void update(uint32_t temporal, TemporalMoment moment);
  void updateGuard(const Temporal& temporal, TemporalState& state, bool start);
  void updateWindow(const Temporal& temporal, TemporalState& state, bool start);
  void updateLeg(const Temporal& temporal, TemporalState& state, bool start);
  [[nodiscard]] bool fresh(const Temporal& window) const;

  bool tryList(ListKind list);
  [[nodiscard]] const std::vector<Case>& casesOf(ListKind list) const;
  [[nodiscard]] bool mayFire(ListKind list, uint32_t number) const;
  bool fire(CaseOf of, const Case& fired);
  void move(CaseOf of, const Case& fired);
  void enter(StateId target);
  void resume();
  void sample();
  void startActivity(ListKind list, Phase phase);
  void initialise(bool of_state);

  [[nodiscard]] const Activity& activity(ListKind list) const;
  void call(ListKind list, Phase phase);
  void run(BlockId block);
  void execute(const Statement& statement);
  void assign(VariableId id, double value);
  void note(NoteKind kind, const std::string& text, std::vector<double> values);
  [[nodiscard]] std::vector<double> numbers(std::span<const ExprId> ids) const;
  TickResult result();

  const Mission& mission_;
  /// Guards are evaluated in every tick. They follow from the mission: copies of this share them.
  std::shared_ptr<Evaluations> evaluations_;
  uint32_t stack_depth_;
  std::vector<SensorState> sensors_;
  std::vector<double> variables_;
  std::vector<TemporalState> temporals_;
  std::vector<Frame> stack_;
  StateId state_{0};
  Limit limit_ = kNoLimit;
  bool just_returned_ = false;
  double mission_time_ = 0;
  double entered_ = 0;
  double resumed_ = 0;
  double sampling_ = 0;
  Externals externals_;
  /// The result of each use in this tick. An expression that is evaluated later may be the first to
  /// need it.
  mutable std::vector<std::optional<double>> called_;
  bool started_ = false;
  bool finished_ = false;
  TickResult told_;  ///< of the tick that is running
};

}  // namespace glider::ir
