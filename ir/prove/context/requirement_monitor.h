// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/eval/interpreter.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glider::ir {

/// Checks a requirement while the interpreter runs: the reference for the results of proofs. It
/// does not use Z3.
class RequirementMonitor {
 public:
  /// `surface_depth_m`: the vehicle is at the surface if it is not deeper than this. `depth` is the
  /// sensor that the true depth replaces in the condition of `always`. Mission and requirement must
  /// outlive this.
  RequirementMonitor(const Mission& mission, const Requirement& requirement, double surface_depth_m,
                     std::optional<SensorId> depth);

  /// Checks a tick, the start first, after the interpreter has made it. `true_depth` (m) is NaN
  /// where it is not known.
  void tick(const Interpreter& run, double mission_time, const TickResult& result,
            double true_depth);

  /// A moment after the latest tick, at which the mission makes none: nothing of it changes but the
  /// time. `last` is what the latest tick did.
  void still(const Interpreter& run, double mission_time, const TickResult& last,
             double true_depth);
  /// Whether the mission would violate the requirement if it went on as it is for long enough:
  /// what it owes at the latest tick has a time. `last` and `true_depth` are of that tick.
  [[nodiscard]] bool owes(const Interpreter& run, double mission_time, const TickResult& last,
                          double true_depth) const;

  /// When the requirement was violated (for Reach: satisfied); empty: not yet.
  [[nodiscard]] std::optional<double> when() const { return when_; }
  /// How it was violated, as the requirement's monitor describes it; empty: it has none.
  [[nodiscard]] const std::string& words() const { return words_; }
  /// What it was due to, and since what mission time.
  struct Due {
    double since = 0;
    std::string cause;
  };
  /// After a violation of what became due at a time of its own.
  [[nodiscard]] const std::optional<Due>& due() const { return due_; }

 private:
  [[nodiscard]] bool enters(const TickResult& result, StateId state) const;
  /// As the requirement reads it: variables of its monitor, and the true depth.
  [[nodiscard]] Value valueOf(ExprId id, const Interpreter& run, double true_depth) const;
  [[nodiscard]] bool observed(const Observation& observation, const TickResult& result) const;
  void watch(const Interpreter& run, const TickResult& result, double true_depth);
  void execute(BlockId block, const Interpreter& run, double true_depth);
  [[nodiscard]] bool conditionIsFalse(const Interpreter& run, double true_depth) const;

  const Mission& m_;
  const Requirement& requirement_;
  double surface_depth_m_;
  std::optional<SensorId> depth_;
  std::shared_ptr<Evaluations> evaluations_;  ///< copies of this share them
  bool started_ = false;
  bool finished_ = false;        ///< by an earlier tick: nothing more is checked
  std::optional<double> still_;  ///< mission time, s, where no tick says it
  StateId before_;
  bool after_seen_ = false;
  double last_surface_ = 0;
  std::vector<double> memory_;  ///< of the monitor's variables, by variable; NaN: unknown
  std::string words_;
  std::optional<Due> due_;
  std::optional<double> when_;
};

}  // namespace glider::ir
