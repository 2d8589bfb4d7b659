// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/sensors/noise.h"
#include "simulator/sensors/sensor_settings.h"

namespace glider::simulator {

/// Standard deviations of the noise.
struct AttitudeSettings {
  double pitch_rad = 0.009;
  double heading_rad = 0.01;

  static constexpr ScenarioKey kKeys[] = {{"sensors", "pitch_rad"}, {"sensors", "heading_rad"}};
  void read(ScenarioTables& tables);
};

/// The compass and tilt sensor.
class AttitudeSensor {
 public:
  using Settings = AttitudeSettings;

  AttitudeSensor(uint64_t seed, const Settings& settings)
      : pitch_noise_(seed, "m_pitch"), heading_noise_(seed, "m_heading"), settings_(settings) {}

  double pitch(double truth) { return truth + pitch_noise_.normal(settings_.pitch_rad); }
  /// The reading for a magnetic heading, rad; in [0, 2 pi).
  double heading(double truth);

 private:
  Noise pitch_noise_, heading_noise_;
  Settings settings_;
};

}  // namespace glider::simulator
