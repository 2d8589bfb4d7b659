// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/seat_mission.h"

#include "codegen/sensor_sources.h"
#include "runtime/imc/usual.h"

namespace glider::codegen {
namespace {

constexpr SensorSource kImcSources[] = {
#define READING(reading, source, unit) {source, unit},
#include "runtime/imc/readings.def"
#undef READING
};

constexpr SensorSource kReconSources[] = {
#define READING(reading, source, unit) {source, unit},
#include "runtime/recon/readings.def"
#undef READING
};

/// Adds to `mission` what each of them has: the vehicle's limits and its sensors.
template <typename Mission>
support::Result<Mission> withVehicle(Mission mission, const platforms::Platform& platform,
                                     std::span<const SensorSource> known) {
  const platforms::Envelope& envelope = platform.envelope;
  mission.greatest_depth_m = envelope.greatest_depth_m;
  mission.slowest_m_s = envelope.slowest_m_s;
  mission.fastest_m_s = envelope.fastest_m_s;
  mission.usual_m_s = envelope.usual_speed_m_s;
  const auto count = readSources(platform, known, mission.sensors, mission.sources);
  if (!count) {
    return std::unexpected(count.error());
  }
  mission.count = *count;
  return mission;
}

}  // namespace

bool speaksImc(const platforms::Platform& platform) {
  return speaks(platform, "imc");
}

bool speaksRecon(const platforms::Platform& platform) {
  return speaks(platform, "recon");
}

support::Result<GliderImcMission> imcMissionOf(const platforms::Platform& platform) {
  GliderImcMission imc{};
  imc.timeout_s = runtime::imc::kTimeoutSecs;
  imc.loiter_m = runtime::imc::kLoiterMetres;
  imc.start_depth_m = platform.world.start_depth_m;
  return withVehicle(imc, platform, kImcSources);
}

support::Result<GliderReconMission> reconMissionOf(const platforms::Platform& platform) {
  return withVehicle(GliderReconMission{}, platform, kReconSources);
}

}  // namespace glider::codegen
