// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/eval/interpreter.h"
#include "ir/prove/falsification/rng.h"

#include <cstdint>
#include <string>
#include <vector>

namespace glider::analysis {

/// The same random readings for two versions of a mission: each sensor keeps its value for a while,
/// then gets another, often next to a number that one of the versions contains, or none.
class RandomReadings {
 public:
  /// Both outlive this.
  RandomReadings(const ir::Mission& before, const ir::Mission& after, uint64_t seed);

  /// The next tick; the first is at mission time 0.
  void next();
  [[nodiscard]] double missionTime() const { return mission_time_; }
  /// The readings of this tick for one of the versions.
  [[nodiscard]] std::vector<ir::SensorUpdate> frame(const ir::Mission& mission) const;

 private:
  struct Sensor {
    std::string vehicle_name;
    std::vector<double> often;  ///< raw
    double lowest = 0, highest = 0;
    double raw = 0;  ///< NaN: nothing is reported
    double until = 0;
  };

  void add(const ir::Mission& mission);
  void addConstants(const ir::Mission& mission, const ir::Sensor& of, Sensor& sensor) const;
  double draw(const Sensor& sensor);

  ir::prove::Rng rng_;
  std::vector<Sensor> sensors_;
  double mission_time_ = 0;
  double longest_gap_;
  bool started_ = false;
};

}  // namespace glider::analysis
