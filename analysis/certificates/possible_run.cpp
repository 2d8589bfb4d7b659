// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/certificates/possible_run.h"

#include "analysis/certificates/run_vehicle.h"
#include "ir/certify/obligations.h"
#include "ir/eval/interpreter.h"
#include "ir/prove/context/proof_context.h"
#include "ir/prove/context/requirement_monitor.h"
#include "ir/worlds/depth_sensor.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace glider::analysis {
namespace {

/// The clock of the vehicle counts in steps of 2^-22 s (docs/verification.md, Numbers).
constexpr double kClockSteps = 1 << 22;
constexpr uint32_t kWide = 8;

/// As a sensor of so many bytes stores it.
double stored(double value, uint32_t bytes) {
  return bytes == kWide ? value : static_cast<double>(static_cast<float>(value));
}

/// A trace as a flight of the environment model: each tick is checked against the gap, the
/// readings, the vehicle (RunVehicle) and the assumptions, while the interpreter follows. It shares
/// no rule with the prover, which wrote the trace.
class Flight {
 public:
  Flight(const support::Trace& run, const compiler::Checked& checked)
      : run_(run),
        m_(checked.mission()),
        assumed_(checked.worlds.assumed.mission),
        platform_(checked.worlds.assumed.platform),
        gap_s_(ir::certify::longestGap(assumed_, platform_)),
        depth_sensor_(ir::depthSensor(m_, platform_)),
        true_depth_(run.column("true_depth")),
        interpreter_(m_, checked.facts.stack_depth),
        reached_(m_, m_.requirements[*run.requirement], platform_.world.surface_depth_m,
                 depth_sensor_),
        vehicle_(platform_) {
    for (const ir::Sensor& sensor : m_.sensors) {
      columns_.push_back(run.column(sensor.vehicle_name));
    }
    for (const ir::Assumption& assumption : m_.assumptions) {
      if (assumption.isWatched()) {
        watched_.push_back(&assumption);
        watches_.emplace_back(m_, assumption.watch, platform_.world.surface_depth_m, depth_sensor_);
      }
    }
  }

  std::string whyImpossible(const std::vector<double>& parameters) {
    if (true_depth_ < 0) {
      return "it does not say how deep the vehicle is";
    }
    for (size_t row = 0; row < run_.rowCount() && !reached_.when(); ++row) {
      std::string why = tick(row, parameters);
      if (!why.empty()) {
        return fmt::format("at {:.9g} s {}", time(row), why);
      }
      if (finished_) {
        break;
      }
    }
    return "";
  }

 private:
  [[nodiscard]] double time(size_t row) const { return run_.at(row, 1); }

  std::string tick(size_t row, const std::vector<double>& parameters) {
    for (const auto& check : {&Flight::clock, &Flight::readings, &Flight::motion}) {
      if (std::string why = (this->*check)(row); !why.empty()) {
        return why;
      }
    }
    std::vector<ir::SensorUpdate> frame;
    for (uint32_t i = 0; i < columns_.size(); ++i) {
      frame.push_back({{i}, run_.at(row, columns_[i])});
    }
    const ir::TickResult result =
        row == 0 ? interpreter_.start(frame, parameters) : interpreter_.tick(time(row), frame);
    vehicle_.obey(result.actions, time(row));
    finished_ = result.finished;
    reached_.tick(interpreter_, time(row), result, depth(row));
    return assumptions(row, result);
  }

  std::string clock(size_t row) {
    const double now = time(row);
    if (!std::isfinite(now) || std::rint(now * kClockSteps) != now * kClockSteps) {
      return "its mission time is not one of the vehicle's clock";
    }
    if (row == 0) {
      return now == 0 ? "" : "it begins, and not at mission time 0";
    }
    const double gap = now - time(row - 1);
    if (gap < 0) {
      return "its mission time goes back";
    }
    return gap <= gap_s_ ? ""
                         : fmt::format(
                               "{:.9g} s have passed since the tick before, and it can be "
                               "at most {:.9g} s",
                               gap, gap_s_);
  }

  std::string readings(size_t row) {
    for (size_t i = 0; i < columns_.size(); ++i) {
      const ir::Sensor& sensor = m_.sensors[i];
      const auto* row_of_platform = platform_.find(sensor.vehicle_name);
      const double raw = run_.at(row, columns_[i]);
      if (row_of_platform == nullptr || std::isnan(raw)) {
        continue;
      }
      const uint32_t bytes = row_of_platform->bytes;
      if (raw < stored(row_of_platform->lowest, bytes) ||
          raw > stored(row_of_platform->highest, bytes)) {
        return fmt::format("{} reports {:.9g}, which is outside of its range", sensor.vehicle_name,
                           raw);
      }
      if (depth_sensor_ && depth_sensor_->index == i && !near(raw, depth(row), bytes)) {
        return fmt::format("{} reports {:.9g} m at a depth of {:.9g} m", sensor.vehicle_name, raw,
                           depth(row));
      }
    }
    return "";
  }

  /// V7, of a reading as the vehicle stores it.
  [[nodiscard]] bool near(double raw, double depth_m, uint32_t bytes) const {
    const double error = platform_.world.depth_error_m;
    return raw >= stored(depth_m - error, bytes) && raw <= stored(depth_m + error, bytes);
  }

  std::string motion(size_t row) {
    const RunVehicle::Depths allowed =
        row == 0 ? vehicle_.atStart() : vehicle_.later(time(row - 1), time(row));
    if (!allowed.contains(depth(row))) {
      return fmt::format(
          "the vehicle is at {:.9g} m, and can only be between {:.9g} m and {:.9g} m", depth(row),
          allowed.least, allowed.greatest);
    }
    row == 0 ? vehicle_.start(depth(row)) : vehicle_.moveTo(depth(row));
    return "";
  }

  std::string assumptions(size_t row, const ir::TickResult& result) {
    for (size_t i = 0; i < watches_.size(); ++i) {
      watches_[i].tick(interpreter_, time(row), result, depth(row));
      if (watches_[i].when()) {
        return fmt::format("it breaks the assumption `{}`", watched_[i]->words);
      }
    }
    return "";
  }

  [[nodiscard]] double depth(size_t row) const { return run_.at(row, true_depth_); }

  const support::Trace& run_;
  const ir::Mission& m_;
  const ir::Mission& assumed_;
  const platforms::Platform& platform_;
  double gap_s_;
  std::optional<ir::SensorId> depth_sensor_;
  int true_depth_;
  std::vector<int> columns_;
  ir::Interpreter interpreter_;
  ir::RequirementMonitor reached_;
  std::vector<const ir::Assumption*> watched_;
  std::vector<ir::RequirementMonitor> watches_;
  RunVehicle vehicle_;
  bool finished_ = false;
};

}  // namespace

std::string whyImpossible(const support::Trace& run, const compiler::Checked& checked,
                          const std::vector<double>& parameters) {
  return Flight(run, checked).whyImpossible(parameters);
}

}  // namespace glider::analysis
