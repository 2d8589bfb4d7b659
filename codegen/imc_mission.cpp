// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/imc_mission.h"

#include "codegen/sensor_sources.h"
#include "runtime/imc/usual.h"

namespace glider::codegen {
namespace {

constexpr SensorSource kImcSources[] = {
#define READING(reading, source, unit) {source, unit},
#include "runtime/imc/readings.def"
#undef READING
};

}  // namespace

bool speaksImc(const platforms::Platform& platform) {
  return speaks(platform, "imc");
}

support::Result<GliderImcMission> imcMissionOf(const platforms::Platform& platform) {
  const platforms::Envelope& envelope = platform.envelope;
  GliderImcMission imc{.greatest_depth_m = envelope.greatest_depth_m,
                       .slowest_m_s = envelope.slowest_m_s,
                       .fastest_m_s = envelope.fastest_m_s,
                       .usual_m_s = envelope.usual_speed_m_s,
                       .timeout_s = runtime::imc::kTimeoutSecs,
                       .loiter_m = runtime::imc::kLoiterMetres,
                       .start_depth_m = platform.world.start_depth_m,
                       .vehicle = 0,
                       .count = 0,
                       .sensors = {},
                       .sources = {}};
  const auto count = readSources(platform, kImcSources, imc.sensors, imc.sources);
  if (!count) {
    return std::unexpected(count.error());
  }
  imc.count = *count;
  return imc;
}

}  // namespace glider::codegen
