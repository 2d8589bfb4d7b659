// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/eval/interpreter.h"

#include <optional>
#include <string>

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

  /// When the requirement was violated (for Reach: satisfied); empty: not yet.
  [[nodiscard]] std::optional<double> when() const { return when_; }

 private:
  [[nodiscard]] bool enters(const TickResult& result, StateId state) const;
  [[nodiscard]] bool conditionIsFalse(const Interpreter& run, double true_depth) const;

  const Mission& m_;
  const Requirement& requirement_;
  double surface_depth_m_;
  std::optional<SensorId> depth_;
  bool started_ = false;
  bool finished_ = false;  ///< by an earlier tick: nothing more is checked
  StateId before_;
  bool after_seen_ = false;
  double last_surface_ = 0;
  std::optional<double> when_;
};

}  // namespace glider::ir
