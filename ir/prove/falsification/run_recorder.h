// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/eval/interpreter.h"
#include "ir/prove/context/proof_context.h"
#include "ir/prove/context/requirement_monitor.h"
#include "ir/prove/falsification/counterexample.h"
#include "ir/prove/falsification/vehicle_clocks.h"

#include <optional>
#include <span>
#include <vector>

namespace glider::ir::prove {

/// Flies a mission on the interpreter, checks requirements, and records the trace.
class RunRecorder {
 public:
  /// All outlive this.
  RunRecorder(const ProofContext& proof_context, uint32_t stack_depth,
              std::span<const Requirement> requirements);

  /// A tick with these readings, by sensor (SI units; NaN: unknown); the first is the start.
  /// `depth` is the true depth, m; NaN if unknown.
  void start(std::vector<double> parameters, const std::vector<double>& readings, double depth);
  void tick(double time, const std::vector<double>& readings, double depth);
  /// What a tick leaves as it is.
  enum class Keeps : uint8_t {
    Control,  ///< the state and the call stack
    Values    ///< also the variables of the mission and of states
  };
  /// The same if it keeps that; otherwise does nothing and returns false.
  bool tickIfQuiet(double time, const std::vector<double>& readings, double depth, Keeps keeps);

  [[nodiscard]] const TickResult& last() const { return last_; }
  [[nodiscard]] double now() const { return result_.ticks.back().mission_time; }
  /// Whether one of the requirements is violated (for Reach: satisfied).
  [[nodiscard]] bool hit() const { return hit_.has_value(); }
  /// The sensor that reports the depth, if the mission reads it.
  [[nodiscard]] std::optional<SensorId> depthSensor() const { return depth_sensor_; }
  /// The counterexample; to be called once, after a hit.
  Counterexample take();

 private:
  std::vector<SensorUpdate> frameOf(const std::vector<double>& readings) const;
  [[nodiscard]] bool keepsValues(const Interpreter& after) const;
  void keep(TickResult result, double time, std::vector<SensorUpdate> frame, double depth);
  void tell(const TickResult& result, double time);
  void describeDue();
  void describeValues();

  const ProofContext& proof_context_;
  const Mission& m_;
  std::span<const Requirement> requirements_;
  std::optional<SensorId> depth_sensor_;
  bool reads_variation_ = false;  ///< whether the mission itself reads it, apart from its compass
  std::vector<bool> wide_;        ///< by sensor: whether the vehicle stores it in 8 bytes
  std::vector<RequirementMonitor> monitors_;  ///< one for each requirement
  std::vector<RequirementMonitor> later_;     ///< the same, without the start
  std::vector<RequirementMonitor> assumed_;   ///< one for each assumption that is watched
  VehicleClocks clocks_;
  bool assumptions_hold_ = true;  ///< up to now, and the clocks go on: otherwise nothing is shown
  std::optional<size_t> hit_;     ///< the first that is violated (Reach: satisfied)
  std::optional<Interpreter> interpreter_;
  TickResult last_;
  Counterexample result_;
};

}  // namespace glider::ir::prove
