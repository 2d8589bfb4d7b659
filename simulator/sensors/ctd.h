// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/sensors/climb_watch.h"
#include "simulator/sensors/noise.h"
#include "simulator/sensors/settings.h"

#include <deque>
#include <functional>
#include <limits>
#include <optional>

namespace glider::simulator {

/// The CTD of the science bay, read once a second: the water in its duct, and what can go wrong
/// with a reading on its way.
class Ctd {
 public:
  struct Reading {
    double temperature_degC = 0;
    double depth_m = 0;       ///< true depth of the vehicle, from the CTD's own pressure
    double conductivity = 0;  ///< S/m
  };
  /// The true temperature (degC) at a depth (m), where the vehicle is.
  using Water = std::function<double(double depth_m)>;

  Ctd(uint64_t seed, const CtdSettings& settings);

  /// The reading that the sensor gives at `now_s`; none when it fails or has none yet.
  std::optional<Reading> read(const Water& water, double depth_m, double now_s);

 private:
  struct Measured {
    double time_s;
    Reading reading;
  };
  /// Renews the water in the duct as far as it is flushed.
  void flush(double outside_degC, double depth_m, double now_s);
  /// The share of the water in the duct that is renewed at `now_s`.
  [[nodiscard]] double renewed(double now_s) const;
  void noteClimb(double depth_m, double now_s);
  /// The newest of the readings that are old enough to be given.
  std::optional<Reading> due(double now_s);

  CtdSettings settings_;
  Noise temperature_noise_, dropout_, depth_noise_, repeat_;
  ClimbWatch turns_;
  bool stale_climb_ = false;
  double stale_climbs_ = 0;
  double in_duct_ = std::numeric_limits<double>::quiet_NaN();
  std::deque<Measured> on_their_way_;
  std::optional<Reading> given_;
};

}  // namespace glider::simulator
