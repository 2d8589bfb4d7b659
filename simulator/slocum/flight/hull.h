// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/hull.h"
#include "platforms/load/platform.h"

namespace glider::simulator {

/// The hull that the software of this vehicle passes to hookbeh.
inline hooks::Hull hullOf(const platforms::Platform& platform) {
  const platforms::Envelope& envelope = platform.envelope;
  return {.greatest_depth_m = envelope.greatest_depth_m,
          .steepest_pitch_rad = envelope.steepest_pitch_rad,
          .shallowest_pitch_rad = envelope.shallowest_pitch_rad,
          .vertical_rate_m_s = envelope.vertical_rate_m_s,
          .pump_cc = envelope.pump_cc,
          .fin_rad = envelope.fin_rad,
          .battery_in = envelope.battery_in};
}

}  // namespace glider::simulator
