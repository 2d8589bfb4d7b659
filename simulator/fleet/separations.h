// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/vehicle/true_place.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace glider::simulator {

/// Two vehicles of a fleet, by their numbers; `one` is the smaller.
struct VehiclePair {
  size_t one = 0;
  size_t other = 0;
  bool operator==(const VehiclePair&) const = default;
};

/// How far apart two vehicles are.
struct PairDistance {
  VehiclePair pair;
  double least_m = std::numeric_limits<double>::infinity();  ///< infinite: they never flew together
  double least_at_s = 0;                                     ///< the first time that they were so
  double least_depths_m[2] = {0, 0};                         ///< of the two then
};

/// The distances between the vehicles of a fleet, along the straight line. A vehicle counts while
/// it flies: what has ended its mission is taken on board.
class Separations {
 public:
  explicit Separations(size_t vehicles);

  /// Looks at all vehicles at one time, s; empty: that one does not fly. Times never decrease.
  void look(double now_s, std::span<const std::optional<TruePlace>> places);

  /// All pairs: (0,1), (0,2), …, (1,2), ….
  [[nodiscard]] const std::vector<PairDistance>& pairs() const { return pairs_; }
  /// Times of the series, s: a minute apart at first, and further apart in a long flight, so that
  /// there are at most kMostSamples.
  [[nodiscard]] const std::vector<double>& times() const { return times_; }
  /// The least distance of the pair with this number since the time before, for each of times();
  /// infinite while they do not fly together.
  [[nodiscard]] const std::vector<double>& series(size_t pair) const { return series_[pair]; }

  static constexpr size_t kMostSamples = 4096;

 private:
  void sample(double now_s);
  void halve();

  size_t vehicles_;
  std::vector<PairDistance> pairs_;
  std::vector<double> times_;
  std::vector<std::vector<double>> series_;
  std::vector<double> since_;  ///< the least of each pair since the newest sample
  double step_s_ = 60;
};

}  // namespace glider::simulator
