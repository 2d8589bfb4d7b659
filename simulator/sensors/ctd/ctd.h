// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/sensors/ctd/climb_watch.h"
#include "simulator/sensors/instrument.h"
#include "simulator/sensors/noise.h"
#include "simulator/sensors/sensor_settings.h"

#include <deque>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace glider::simulator {

/// A time in which the water in the CTD's duct does not change: the sensor keeps reporting its last
/// temperature.
struct StaleWater {
  double from_s = 0;
  double to_s = 0;
};

/// Climbs on which the CTD's duct is not flushed, as on the lost climb of the paper's Figure 6.
struct StaleClimbs {
  bool on = false;
  double frozen_s = 120;  ///< how long the duct keeps its water after the inflection, s
  double flush_s = 20;    ///< time constant with which the water is then renewed; 0: at once
  double after_s = 0;     ///< climbs that begin earlier are not affected
  double count = 0;       ///< how many climbs; 0: all
};

struct CtdSettings {
  double noise_degC = 0.002;
  double noise_Spm = 0.0002;   ///< of the conductivity: as much salinity as the temperature's
  double dropout = 0;          ///< share of readings that fail
  double repeat_fraction = 0;  ///< share of readings that repeat the previous one
  double late_s = 0;           ///< age of a reading when it is given
  /// How far above or below the vehicle the measured water is (standard deviation, m).
  double non_monotonic_m = 0;
  /// S/m, the same everywhere, as in the vehicle's own simulator; NaN: that of the water
  double conductivity = std::numeric_limits<double>::quiet_NaN();
  std::vector<StaleWater> stale_water = {};
  StaleClimbs stale_climbs = {};

  static constexpr ScenarioKey kKeys[] = {{"ocean", "conductivity_Spm"},
                                          {"sensors", "temperature_degC"},
                                          {"sensors", "ctd_dropout"},
                                          {"sensors", "stale_water"},
                                          {"sensors", "ctd"}};
  void read(ScenarioTables& tables);
};

/// The CTD of the science bay, read once a second: the water in its duct, and the faults of a
/// reading.
class Ctd final : public Instrument {
 public:
  using Settings = CtdSettings;
  struct Reading {
    double temperature_degC = 0;
    double depth_m = 0;       ///< of the vehicle, from the CTD's own pressure
    double conductivity = 0;  ///< S/m
  };
  struct Water {
    double temperature_degC = 0;
    double salinity = 0;
  };
  /// The true water at a depth (m), where the vehicle is.
  using Column = std::function<Water(double depth_m)>;

  Ctd(uint64_t seed, const CtdSettings& settings);

  [[nodiscard]] std::span<const InstrumentSensor> sensors() const override;
  [[nodiscard]] Proglet proglet() const override { return {1, "profile"}; }
  void sample(const Sampling& at, std::span<double> readings) override;
  /// The reading that the sensor gives at `now_s`; none when it fails or has none yet. `swell_m`:
  /// what a swell adds to its pressure.
  std::optional<Reading> read(const Column& water, double depth_m, double now_s,
                              double swell_m = 0);

 private:
  struct Measured {
    double time_s;
    Reading reading;
  };
  /// Renews the water in the duct as far as it is flushed.
  void flush(const Water& outside, double depth_m, double now_s);
  /// The share of the water in the duct that is renewed at `now_s`.
  [[nodiscard]] double renewed(double now_s) const;
  void noteClimb(double depth_m, double now_s);
  /// The conductivity (S/m) measured of the water in the duct at a pressure (dbar).
  [[nodiscard]] double conductivityInDuct(double dbar);
  /// The newest of the readings that are old enough to be given.
  std::optional<Reading> due(double now_s);

  CtdSettings settings_;
  Noise temperature_noise_, conductivity_noise_, dropout_, depth_noise_, repeat_;
  ClimbWatch turns_;
  bool stale_climb_ = false;
  double stale_climbs_ = 0;
  std::optional<Water> in_duct_;
  std::deque<Measured> on_their_way_;
  std::optional<Reading> given_;
};

}  // namespace glider::simulator
