// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/eval/interpreter.h"

#include <optional>
#include <string>

namespace glider::ir {

/// Watches a run of the interpreter for what a requirement asks: the judge of what proofs say.
/// Knows nothing of Z3.
class RequirementMonitor {
 public:
  /// `surface_depth_m`: not deeper than this is at the surface; `depth` is the sensor whose place
  /// the true depth takes in the condition of `always`. Mission and requirement outlive this.
  RequirementMonitor(const Mission& mission, const Requirement& requirement, double surface_depth_m,
                     std::optional<SensorId> depth);

  /// A tick, the start first, after the interpreter has made it. `true_depth` (m) is NaN where
  /// nobody knows.
  void tick(const Interpreter& run, double mission_time, const TickResult& result,
            double true_depth);

  /// When the requirement was broken (of Reach: kept); empty: not yet.
  [[nodiscard]] std::optional<double> when() const { return when_; }

 private:
  [[nodiscard]] bool enters(const TickResult& result, StateId state) const;
  [[nodiscard]] bool conditionIsFalse(const Interpreter& run, double true_depth) const;

  const Mission& m_;
  const Requirement& requirement_;
  double surface_depth_m_;
  std::optional<SensorId> depth_;
  bool started_ = false;
  bool finished_ = false;  ///< by an earlier tick: nothing is asked any more
  StateId before_;
  bool after_seen_ = false;
  double last_surface_ = 0;
  std::optional<double> when_;
};

}  // namespace glider::ir
