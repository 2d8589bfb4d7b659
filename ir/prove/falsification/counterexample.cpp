// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/falsification/counterexample.h"

#include "ir/prove/context/vehicle_clock.h"
#include "ir/prove/falsification/depth_limits.h"
#include "ir/prove/falsification/run_recorder.h"
#include "support/rounded.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace glider::ir::prove {
namespace {

constexpr double kUnknownValue = std::numeric_limits<double>::quiet_NaN();
constexpr size_t kMostTicks = 200000;

/// Rounded to the digits that a launch accepts, and to a number that it does.
double shorter(double value, const Variable& parameter) {
  constexpr double kFar = 1e9;
  const double near =
      std::clamp(value, std::min(-kFar, parameter.highest), std::max(kFar, parameter.lowest));
  const double rounded = support::rounded(near, 9);
  return rounded >= parameter.lowest && rounded <= parameter.highest ? rounded : value;
}

/// `run` as a vehicle can fly it.
Run rounded(Run run, const Mission& mission) {
  for (Step& step : run.steps) {
    step.mission_time = onVehicleClock(step.mission_time);
  }
  size_t number = 0;
  for (const Variable& variable : mission.variables) {
    if (variable.kind == VariableKind::Parameter && number < run.parameters.size()) {
      run.parameters[number] = shorter(run.parameters[number], variable);
      ++number;
    }
  }
  return run;
}

class Concretizer {
 public:
  Concretizer(const Run& run, const ProofContext& proof_context, uint32_t stack_depth,
              const Requirement& requirement)
      : run_(rounded(run, proof_context.mission)),
        proof_context_(proof_context),
        recorder_(proof_context, stack_depth, {&requirement, 1}),
        limits_(proof_context.platform, run_.steps.empty() ? 0 : startDepth(run_.steps.front())) {}

  std::optional<Counterexample> spell() {
    if (run_.steps.empty() || failedCondition(proof_context_.mission, run_.parameters)) {
      return std::nullopt;
    }
    const Step& first = run_.steps.front();
    recorder_.start(run_.parameters, withDepth(first, limits_.depth()), limits_.depth());
    follow(0);
    for (size_t i = 1; i < run_.steps.size() && !recorder_.hit(); ++i) {
      if (!fill(run_.steps[i - 1], run_.steps[i]) || recorder_.hit() || !arrive(run_.steps[i])) {
        break;
      }
    }
    return recorder_.hit() ? std::optional(recorder_.take()) : std::nullopt;
  }

 private:
  [[nodiscard]] double startDepth(const Step& first) const {
    return std::clamp(first.depth.value_or(0), 0.0, proof_context_.platform.world.start_depth_m);
  }

  /// The depth that a vehicle can have at mission time `time` which is nearest to `wanted`, or to
  /// where it is. The trace has depths only if the question takes them into account, and none
  /// between its steps.
  [[nodiscard]] double depthAt(double time, std::optional<double> wanted) const {
    const double from = recorder_.now();
    const double highest = limits_.highest(from, time);
    return std::clamp(wanted.value_or(limits_.depth()),
                      std::min(limits_.lowest(from, time), highest), highest);
  }

  /// What the newest tick has commanded.
  void follow(double depth) {
    limits_.moveTo(depth);
    for (const Action& action : recorder_.last().actions) {
      if (const auto* command = std::get_if<CommandRun>(&action); command == nullptr) {
        limits_.obeyAnything();
      } else if (!command->refused) {
        limits_.obey(*command, recorder_.now());
      }
    }
  }

  /// The readings of a step; its depth, unless the question is about depths, is that of the
  /// vehicle.
  [[nodiscard]] std::vector<double> withDepth(const Step& step, double depth) const {
    return step.depth ? step.readings : withDepth(step.readings, depth);
  }

  /// `readings` with the depth of the vehicle, if they have a known depth.
  [[nodiscard]] std::vector<double> withDepth(std::vector<double> readings, double depth) const {
    const auto sensor = recorder_.depthSensor();
    return sensor && readings[sensor->index] == readings[sensor->index]
               ? seeing(std::move(readings), depth)
               : readings;
  }

  /// `readings` with the depth of the vehicle.
  std::vector<double> seeing(std::vector<double> readings, double depth) const {
    if (recorder_.depthSensor() && depth == depth) {
      readings[recorder_.depthSensor()->index] = depth;
    }
    return readings;
  }

  static std::optional<double> onTheWay(const Step& from, const Step& to, double share) {
    return from.depth && to.depth ? std::optional(std::lerp(*from.depth, *to.depth, share))
                                  : std::nullopt;
  }

  /// Makes ticks between two steps, at which nothing fires.
  bool fill(const Step& from, const Step& to) {
    const double cycle = proof_context_.platform.envelope.cycle_s;
    const double span = to.mission_time - from.mission_time;
    const auto count = static_cast<size_t>(std::max(0.0, std::ceil(span / cycle) - 1));
    if (ticks_ + count > kMostTicks) {
      return false;
    }
    ticks_ += count;
    for (size_t i = 1; i <= count && !recorder_.hit(); ++i) {
      const double time = from.mission_time + cycle * static_cast<double>(i);
      const double share = (time - from.mission_time) / span;
      const double depth = depthAt(time, onTheWay(from, to, share));
      if (!fillOne(from, to, time, depth)) {
        // Ticks may be lost for so long: in this trace these are.
        return to.mission_time - recorder_.now() <= proof_context_.tick_gap_s;
      }
    }
    return true;
  }

  /// Tries the readings of the next step, those of the step before, unknown ones, and random ones:
  /// the first with which the mission stays as it is, or at least its state does.
  bool fillOne(const Step& from, const Step& to, double time, double depth) {
    const std::vector<double> none(proof_context_.mission.sensors.size(), kUnknownValue);
    const auto some = {seeing(to.readings, depth), withDepth(to.readings, depth),
                       withDepth(from.readings, depth), seeing(none, depth), none};
    const auto goesBy = [&](const std::vector<double>& readings, RunRecorder::Keeps keeps) {
      const bool fits = recorder_.tickIfQuiet(time, readings, depth, keeps);
      if (fits) {
        follow(depth);
      }
      return fits;
    };
    const auto anyGoesBy = [&](RunRecorder::Keeps keeps) {
      return std::ranges::any_of(some, [&](const auto& one) { return goesBy(one, keeps); });
    };
    if (anyGoesBy(RunRecorder::Keeps::Values) || anyGoesBy(RunRecorder::Keeps::Control)) {
      return true;
    }
    for (int i = 0; i < kTries; ++i) {
      if (goesBy(withDepth(anyReadings(), depth), RunRecorder::Keeps::Control)) {
        return true;
      }
    }
    return false;
  }

  /// Readings within their ranges, or unknown.
  std::vector<double> anyReadings() {
    std::vector<double> readings;
    for (const Interval& range : proof_context_.sensors) {
      std::uniform_real_distribution<double> within(std::max(range.lowest, -1e9),
                                                    std::min(range.highest, 1e9));
      readings.push_back(random_() % 3 == 0 || range.empty ? kUnknownValue : within(random_));
    }
    return readings;
  }

  /// Makes the step's own tick; it must lead where `run` says, or violate the requirement.
  bool arrive(const Step& step) {
    const double depth = depthAt(step.mission_time, step.depth);
    recorder_.tick(step.mission_time, withDepth(step, depth), depth);
    follow(depth);
    const TickResult& last = recorder_.last();
    const bool right = !last.finished && last.state == step.after.state &&
                       last.stack.size() == step.after.stack.size();
    return right || recorder_.hit();
  }

  static constexpr int kTries = 30;

  const Run run_;
  const ProofContext& proof_context_;
  RunRecorder recorder_;
  DepthLimits limits_;
  size_t ticks_ = 0;
  std::mt19937_64 random_{1};
};

}  // namespace

std::optional<Counterexample> concretize(const Run& run, const ProofContext& proof_context,
                                         uint32_t stack_depth, const Requirement& requirement) {
  return Concretizer(run, proof_context, stack_depth, requirement).spell();
}

}  // namespace glider::ir::prove
