// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/sensors/concentration_noise.h"
#include "simulator/sensors/instrument.h"
#include "simulator/sensors/sensor_settings.h"

#include <limits>

namespace glider::simulator {

struct OptodeSettings {
  double noise_uM = 0.5;
  /// Above and below the thermocline; NaN: the vehicle carries no optode.
  double surface_uM = std::numeric_limits<double>::quiet_NaN();
  double bottom_uM = std::numeric_limits<double>::quiet_NaN();

  static constexpr ScenarioKey kKeys[] = {
      {"sensors", "oxygen_uM"}, {"ocean", "surface_oxygen_uM"}, {"ocean", "bottom_oxygen_uM"}};
  void read(ScenarioTables& tables);
};

/// Reads dissolved oxygen, which follows the thermocline.
class Optode final : public Instrument {
 public:
  using Settings = OptodeSettings;

  Optode(uint64_t seed, const Settings& settings);
  [[nodiscard]] std::span<const InstrumentSensor> sensors() const override;
  [[nodiscard]] Proglet proglet() const override { return {54, "oxy4"}; }
  [[nodiscard]] std::string_view setting() const override;
  [[nodiscard]] bool carried() const override;
  void sample(const Sampling& at, std::span<double> readings) override;

 private:
  Settings settings_;
  ConcentrationNoise noise_;
};

}  // namespace glider::simulator
