// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/recon_mission.h"

#include "codegen/sensor_sources.h"

namespace glider::codegen {
namespace {

constexpr SensorSource kReconSources[] = {
#define READING(reading, source, unit) {source, unit},
#include "runtime/recon/readings.def"
#undef READING
};

}  // namespace

bool speaksRecon(const platforms::Platform& platform) {
  return speaks(platform, "recon");
}

support::Result<GliderReconMission> reconMissionOf(const platforms::Platform& platform) {
  const platforms::Envelope& envelope = platform.envelope;
  GliderReconMission recon{.greatest_depth_m = envelope.greatest_depth_m,
                           .slowest_m_s = envelope.slowest_m_s,
                           .fastest_m_s = envelope.fastest_m_s,
                           .usual_m_s = envelope.usual_speed_m_s,
                           .count = 0,
                           .unused = 0,
                           .sensors = {},
                           .sources = {}};
  const auto count = readSources(platform, kReconSources, recon.sensors, recon.sources);
  if (!count) {
    return std::unexpected(count.error());
  }
  recon.count = *count;
  return recon;
}

}  // namespace glider::codegen
