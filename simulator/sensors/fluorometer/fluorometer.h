// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/sensors/concentration_noise.h"
#include "simulator/sensors/instrument.h"
#include "simulator/sensors/sensor_settings.h"

#include <limits>
#include <vector>

namespace glider::simulator {

/// Water rich in chlorophyll: peak · exp(-(r/radius)² - ((z - depth)/thickness)²).
struct Patch {
  double x = 0, y = 0;
  double radius_m = 0;
  double depth_m = 0;
  double thickness_m = 0;
  double peak_ugpl = 0;
};

struct FluorometerSettings {
  double noise_ugpl = 0.02;
  /// Outside all patches; NaN: the vehicle carries no fluorometer.
  double background_ugpl = std::numeric_limits<double>::quiet_NaN();
  std::vector<Patch> patches = {};

  static constexpr ScenarioKey kKeys[] = {
      {"sensors", "chlorophyll_ugpl"}, {"ocean", "chlorophyll_ugpl"}, {"ocean", "patch"}};
  void read(ScenarioTables& tables);
  /// In the water at z m down, x and y m east and north of the start; ug/L.
  [[nodiscard]] double chlorophyll(double z, double x, double y) const;
};

/// Reads chlorophyll.
class Fluorometer final : public Instrument {
 public:
  using Settings = FluorometerSettings;

  Fluorometer(uint64_t seed, const Settings& settings);
  [[nodiscard]] std::span<const InstrumentSensor> sensors() const override;
  [[nodiscard]] Proglet proglet() const override { return {48, "flbbcd"}; }
  [[nodiscard]] std::string_view setting() const override;
  [[nodiscard]] bool carried() const override;
  void sample(const Sampling& at, std::span<double> readings) override;

 private:
  Settings settings_;
  ConcentrationNoise noise_;
};

}  // namespace glider::simulator
