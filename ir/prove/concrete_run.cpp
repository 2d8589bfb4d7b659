// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/concrete_run.h"

#include "ir/prove/run_recorder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace glider::ir::prove {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr size_t kMostTicks = 200000;

class Speller {
 public:
  Speller(const Run& run, const Ground& ground, uint32_t stack_depth,
          const Requirement& requirement)
      : run_(run), ground_(ground), recorder_(ground, stack_depth, requirement) {}

  std::optional<ConcreteRun> spell() {
    if (run_.steps.empty() || failedCondition(ground_.mission, run_.parameters)) {
      return std::nullopt;
    }
    const Step& first = run_.steps.front();
    recorder_.start(run_.parameters, first.readings, first.depth.value_or(kUnknown));
    for (size_t i = 1; i < run_.steps.size() && !recorder_.hit(); ++i) {
      if (!fill(run_.steps[i - 1], run_.steps[i]) || !arrive(run_.steps[i])) {
        break;
      }
    }
    return recorder_.hit() ? std::optional(recorder_.take()) : std::nullopt;
  }

 private:
  /// `readings` with the depth that the vehicle has, if it is known there.
  std::vector<double> withDepth(std::vector<double> readings, double depth) const {
    if (recorder_.depthSensor() && depth == depth) {
      double& reading = readings[recorder_.depthSensor()->index];
      reading = reading == reading ? depth : reading;
    }
    return readings;
  }

  /// Ticks between two steps, at which nothing fires.
  bool fill(const Step& from, const Step& to) {
    const double cycle = ground_.platform.envelope.cycle_s;
    const double span = to.mission_time - from.mission_time;
    const auto count = static_cast<size_t>(std::max(0.0, std::ceil(span / cycle) - 1));
    if (ticks_ + count > kMostTicks) {
      return false;
    }
    ticks_ += count;
    for (size_t i = 1; i <= count && !recorder_.hit(); ++i) {
      const double time = from.mission_time + cycle * static_cast<double>(i);
      const double share = (time - from.mission_time) / span;
      const double depth =
          from.depth && to.depth ? *from.depth + share * (*to.depth - *from.depth) : kUnknown;
      if (!fillOne(from, to, time, depth)) {
        // Ticks may be lost, for so long: the run is one in which these were.
        return to.mission_time - recorder_.now() <= ground_.platform.world.tick_gap_s;
      }
    }
    return true;
  }

  /// The readings of the step to come, those of the one before, none, and others at random: the
  /// first with which nothing fires.
  bool fillOne(const Step& from, const Step& to, double time, double depth) {
    std::vector<double> none(ground_.mission.sensors.size(), kUnknown);
    if (recorder_.tickIfQuiet(time, withDepth(to.readings, depth), depth) ||
        recorder_.tickIfQuiet(time, withDepth(from.readings, depth), depth) ||
        recorder_.tickIfQuiet(time, none, depth)) {
      return true;
    }
    if (recorder_.depthSensor() && depth == depth) {
      none[recorder_.depthSensor()->index] = depth;
      if (recorder_.tickIfQuiet(time, none, depth)) {
        return true;
      }
    }
    for (int i = 0; i < kTries; ++i) {
      if (recorder_.tickIfQuiet(time, withDepth(anyReadings(), depth), depth)) {
        return true;
      }
    }
    return false;
  }

  /// Readings within their ranges, or unknown.
  std::vector<double> anyReadings() {
    std::vector<double> readings;
    for (const Interval& range : ground_.sensors) {
      std::uniform_real_distribution<double> within(std::max(range.lowest, -1e9),
                                                    std::min(range.highest, 1e9));
      readings.push_back(random_() % 3 == 0 || range.empty ? kUnknown : within(random_));
    }
    return readings;
  }

  /// The step's own tick; it leads where the run says, or the requirement is broken by it.
  bool arrive(const Step& step) {
    recorder_.tick(step.mission_time, step.readings, step.depth.value_or(kUnknown));
    const TickResult& last = recorder_.last();
    const bool right = !last.finished && last.state == step.after.state &&
                       last.stack.size() == step.after.stack.size();
    return right || recorder_.hit();
  }

  static constexpr int kTries = 30;

  const Run& run_;
  const Ground& ground_;
  RunRecorder recorder_;
  size_t ticks_ = 0;
  std::mt19937_64 random_{1};
};

}  // namespace

std::optional<ConcreteRun> spellOut(const Run& run, const Ground& ground, uint32_t stack_depth,
                                    const Requirement& requirement) {
  return Speller(run, ground, stack_depth, requirement).spell();
}

}  // namespace glider::ir::prove
