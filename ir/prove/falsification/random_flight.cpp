// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/falsification/random_flight.h"

#include "ir/core/inside.h"
#include "ir/prove/context/place_read.h"
#include "ir/prove/context/vehicle_clock.h"
#include "ir/prove/falsification/random_place.h"
#include "ir/prove/falsification/random_vehicle.h"
#include "ir/prove/falsification/run_recorder.h"
#include "ir/prove/falsification/vehicle_clocks.h"
#include "ir/prove/geometry/area_map.h"
#include "ir/prove/geometry/steering.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <string>

namespace glider::ir::prove {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kFar = 1e9;  ///< of a range without an end
/// Ticks after which a sparse flight may be given up.
constexpr size_t kSoon = 6;
constexpr double kLostTick = 0.01;
constexpr double kPowerCut = 0.005;
constexpr double kClockUnknown = 0.02;
/// Nearer to a pole a RandomPlace does not move as a vehicle does, degrees.
constexpr double kNearPole = 85;

/// The value that a sensor reports for a while.
struct HeldReading {
  double value = kUnknown;
  bool steady = true;  ///< otherwise another value in every tick
  double until = 0;    ///< mission time
};

class RandomFlight {
 public:
  RandomFlight(const ProofContext& proof_context, uint32_t stack_depth,
               std::span<const Requirement> requirements, const Requirement* place, uint64_t seed,
               FlightLength length)
      : proof_context_(proof_context),
        m_(proof_context.mission),
        length_(length),
        recorder_(proof_context, stack_depth, requirements),
        dice_(seed),
        vehicle_(proof_context.platform, dice_, mannerOf(requirements, seed)),
        showing_(m_.sensors.size()) {
    for (const Sensor& sensor : m_.sensors) {
      landmarks_.push_back(landmarksOf(sensor));
      place_read_.push_back(placeReadBy(sensor, proof_context.platform));
    }
    const VehicleClocks clocks(proof_context);
    for (const SensorId clock : clocks.sensors()) {
      // All clocks of the calendar show one time.
      const bool calendar = isCalendarClock(proof_context.platformSensor(clock));
      calendar_s_ = calendar && !calendar_s_ ? startOfClock(clock) : calendar_s_;
      clocks_.emplace(clock.index, calendar ? *calendar_s_ : startOfClock(clock));
    }
    if (place != nullptr) {
      const auto start = startOf(*place);
      starts_nowhere_ = !start || std::fabs(start->latitude) > kNearPole;
      place_.emplace(start.value_or(Position{}), proof_context.platform, dice_);
      dark_left_s_ = proof_context.tick_gap_s;  // the geofence premise: all outages together
    }
  }

  Flight fly() {
    if (starts_nowhere_) {
      return {};
    }
    double time = 0;
    size_t i = 0;
    recorder_.start(parameters(), readings(time), vehicle_.depth());
    for (; i < length_.ticks && !recorder_.hit() && !recorder_.last().finished; ++i) {
      if (i == kSoon && length_.sparse && calm_ && recorder_.last().state != StateId{0}) {
        return {std::nullopt, i, /*given_up=*/true};
      }
      vehicle_.obey(recorder_.last().actions, time);
      const double step = untilNextTick();
      if (place_) {
        place_->obey(recorder_.last().actions);
      }
      move(time, time + step);
      time += step;
      recorder_.tick(time, readings(time), vehicle_.depth());
    }
    return {recorder_.hit() ? std::optional(recorder_.take()) : std::nullopt, i};
  }

 private:
  /// A vehicle that happens to surface on its own refutes no promise of when it surfaces. Other
  /// dice than those of the readings.
  static Manner mannerOf(std::span<const Requirement> requirements, uint64_t seed) {
    constexpr uint64_t kOthers = 0x9e3779b97f4a7c15;
    Rng dice(seed ^ kOthers);
    const bool surfaces = std::ranges::any_of(requirements, [](const Requirement& requirement) {
      return requirement.kind == RequirementKind::SurfacesEvery;
    });
    return surfaces && dice.chance(0.5) ? Manner::Shy : Manner::Any;
  }

  /// s; a power cut may have any length after which the mission continues.
  double untilNextTick() {
    const platforms::Platform& platform = proof_context_.platform;
    const double shortest = platform.world.tick_gap_s;
    const double longest = std::min(proof_context_.tick_gap_s, dark_left_s_);
    if (longest > shortest && dice_.chance(kPowerCut)) {
      const double cut =
          dice_.chance(0.5) ? longest : onVehicleClock(dice_.within(shortest, longest));
      dark_left_s_ -= cut;
      return cut;
    }
    return length_.sparse || dice_.chance(kLostTick) ? platform.world.tick_gap_s
                                                     : platform.envelope.cycle_s;
  }

  /// Moves in steps in which a vehicle steers.
  void move(double from, double to) {
    const platforms::EnvironmentModel& world = proof_context_.platform.world;
    const bool dark = to - from > world.tick_gap_s;
    for (double time = from; time < to; time += world.tick_gap_s) {
      const double until = std::min(time + world.tick_gap_s, to);
      vehicle_.move(time, until);
      if (place_) {
        place_->move(until - time, vehicle_.depth() <= world.surface_depth_m, dark);
      }
    }
  }

  /// A place in the area of the start that is assumed (none if none is found); otherwise a
  /// waypoint, usually one on the right side; otherwise the middle of an area, if there is one.
  std::optional<Position> startOf(const Requirement& requirement) {
    if (const auto assumed = assumedStart(m_)) {
      return placeInside(*assumed, dice_);
    }
    const std::vector<Position> all = steeringOf(proof_context_).waypoints;
    std::vector<Position> kept;
    std::ranges::copy_if(all, std::back_inserter(kept), [&](const Position& place) {
      return std::ranges::all_of(requirement.geofences, [&](const Geofence& fence) {
        return AreaMap(fence, {place}).clearance(fence, {place}).right_side;
      });
    });
    constexpr double kMostly = 0.8;
    const std::vector<Position>& from = !kept.empty() && dice_.chance(kMostly) ? kept : all;
    if (!from.empty()) {
      return from[dice_.below(from.size())];
    }
    if (requirement.geofences.empty()) {
      return std::nullopt;
    }
    Position middle;
    const std::vector<Position>& corners = requirement.geofences.front().corners;
    for (const Position& corner : corners) {
      middle.latitude += corner.latitude / static_cast<double>(corners.size());
      middle.longitude += corner.longitude / static_cast<double>(corners.size());
    }
    return middle;
  }

  /// The reading of a sensor that reports the vehicle's position; empty for other sensors.
  std::optional<double> placeReading(uint32_t sensor) const {
    const PlaceRead read = place_ ? place_read_[sensor] : PlaceRead::Nothing;
    if (read == PlaceRead::Nothing) {
      return std::nullopt;
    }
    return read == PlaceRead::Latitude ? place_->where().latitude : place_->where().longitude;
  }

  /// Values within their ranges and conditions; the defaults if none are found.
  std::vector<double> parameters() {
    constexpr int kTries = 30;
    for (int i = 0; i < kTries; ++i) {
      std::vector<double> values = defaultParameters(m_);
      size_t number = 0;
      for (const Variable& variable : m_.variables) {
        if (variable.kind == VariableKind::Parameter) {
          double& value = values[number++];
          value = anyParameter(variable, value);
        }
      }
      if (!failedCondition(m_, values)) {
        return values;
      }
    }
    return defaultParameters(m_);
  }

  /// How far a parameter without a limit is set from what is usual: so that a pilot might.
  static double twice(double standard) { return std::max(2 * std::fabs(standard), 1.0); }

  double anyParameter(const Variable& variable, double standard) {
    if (variable.type.kind == TypeKind::Bool) {
      return dice_.below(2);
    }
    switch (dice_.below(4)) {
      case 0:
        return standard;
      case 1:
        return std::isfinite(variable.lowest) ? variable.lowest : standard - twice(standard);
      case 2:
        return std::isfinite(variable.highest) ? variable.highest : standard + twice(standard);
      default:
        return std::clamp(
            std::stod(fmt::format("{:.9g}", dice_.within(std::max(variable.lowest, -kFar),
                                                         std::min(variable.highest, kFar)))),
            variable.lowest, variable.highest);
    }
  }

  /// What a clock of the vehicle shows as the mission begins: often so that a time of the calendar
  /// or of the day that the mission names comes during the flight.
  double startOfClock(SensorId clock) {
    constexpr double kDay_s = 86400, kFirst_s = 1.6e9, kYears_s = 3e8, kFirstDate_s = 946684800;
    constexpr double kChance = 0.7;
    const Interval& range = proof_context_.sensors[clock.index];
    const std::vector<double>& landmarks = landmarks_[clock.index];
    const double soon = dice_.lasting();
    double start = kFirst_s + kYears_s * dice_.unit();
    if (!landmarks.empty() && dice_.chance(kChance)) {
      const double landmark = landmarks[dice_.below(landmarks.size())];
      const double of_day = std::fmod(landmark, kDay_s);
      start = landmark >= kFirstDate_s ? landmark : std::floor(start / kDay_s) * kDay_s + of_day;
      start -= dice_.chance(kChance) ? soon : -soon;
    }
    const double lowest = std::max(range.lowest, 0.0);
    return std::clamp(start, lowest, std::max(range.highest - kYears_s, lowest));
  }

  std::vector<double> readings(double time) {
    std::vector<double> values;
    values.reserve(m_.sensors.size());
    for (uint32_t i = 0; i < m_.sensors.size(); ++i) {
      if (const auto clock = clocks_.find(i); clock != clocks_.end()) {
        values.push_back(dice_.chance(kClockUnknown) ? kUnknown : clock->second + time);
        continue;
      }
      if (time == 0 && m_.sensors[i].isHeard()) {  // nothing is received before the mission begins
        values.push_back(std::numeric_limits<double>::quiet_NaN());
        continue;
      }
      HeldReading& now = showing_[i];
      if (time >= now.until) {
        now = {anyValue(i), calm_ || dice_.chance(0.7),
               calm_ ? std::numeric_limits<double>::infinity() : time + dice_.lasting()};
      } else if (!now.steady) {
        now.value = anyValue(i);
      }
      const bool depth = recorder_.depthSensor() == SensorId{i};
      const bool heard = now.value == now.value;
      // The vehicle knows its position (docs/verification.md), so the mission does.
      const auto place = placeReading(i);
      values.push_back(depth && heard ? vehicle_.reading() : place.value_or(now.value));
    }
    return values;
  }

  /// A value of a sensor: within its range, at its ends, next to a constant of its type, or
  /// unknown.
  double anyValue(uint32_t sensor) {
    const Interval& range = proof_context_.sensors[sensor];
    if (range.empty || dice_.chance(calm_ ? 0.02 : 0.1)) {
      return kUnknown;
    }
    const double lowest = std::max(range.lowest, -kFar);
    const double highest = std::min(range.highest, kFar);
    const std::vector<double>& landmarks = landmarks_[sensor];
    if (!landmarks.empty() && dice_.chance(0.5)) {
      const double landmark = landmarks[dice_.below(landmarks.size())];
      const double reach =
          std::max(1e-3, std::fabs(landmark)) * std::pow(10, -2.0 * dice_.below(4));
      return std::clamp(landmark + 0.01 * reach * dice_.within(-1, 1), lowest, highest);
    }
    return dice_.within(lowest, highest);
  }

  /// Numbers of the sensor's type that the mission names.
  std::vector<double> landmarksOf(const Sensor& sensor) const {
    std::vector<double> found;
    for (const Expr& e : m_.exprs) {
      if (e.op == Op::Constant && e.type == sensor.type) {
        found.push_back(e.number);
      }
    }
    for (const Table& table : m_.tables) {
      if (table.type == sensor.type) {
        found.insert(found.end(), table.values.begin(), table.values.end());
      }
    }
    return found;
  }

  const ProofContext& proof_context_;
  const Mission& m_;
  FlightLength length_;
  RunRecorder recorder_;
  Rng dice_;
  RandomVehicle vehicle_;
  bool starts_nowhere_ = false;       ///< no place in the area of the start is found, or a pole
  std::optional<RandomPlace> place_;  ///< the vehicle's place, if the requirement asks for it
  double dark_left_s_ = std::numeric_limits<double>::infinity();  ///< of power cuts
  bool calm_ = dice_.chance(0.3);  ///< every sensor shows the same all the time
  std::vector<HeldReading> showing_;
  std::vector<std::vector<double>> landmarks_;  ///< by sensor
  std::vector<PlaceRead> place_read_;           ///< by sensor: asked for in every tick
  std::optional<double> calendar_s_;   ///< what clocks of the calendar show as the mission begins
  std::map<uint32_t, double> clocks_;  ///< by sensor: what a clock shows as the mission begins, s
};

}  // namespace

std::optional<Counterexample> flyAtRandom(const ProofContext& proof_context, uint32_t stack_depth,
                                          std::span<const Requirement> requirements, uint64_t seed,
                                          size_t ticks) {
  return RandomFlight(proof_context, stack_depth, requirements,
                      aboutPlaceOf(proof_context, requirements), seed, {ticks})
      .fly()
      .violation;
}

const Requirement* aboutPlaceOf(const ProofContext& proof_context,
                                std::span<const Requirement> requirements) {
  const auto found = std::ranges::find_if(requirements, [&](const Requirement& requirement) {
    return !requirement.geofences.empty() || isAboutPlace(requirement, proof_context);
  });
  return found == requirements.end() ? nullptr : &*found;
}

Flight flyAtRandom(const ProofContext& proof_context, uint32_t stack_depth,
                   const Requirement& requirement, const Requirement* place, uint64_t seed,
                   FlightLength length) {
  return RandomFlight(proof_context, stack_depth, std::span(&requirement, 1), place, seed, length)
      .fly();
}

}  // namespace glider::ir::prove
