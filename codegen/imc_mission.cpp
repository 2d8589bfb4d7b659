// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/imc_mission.h"

#include "runtime/imc/usual.h"
#include "support/diagnostics/ids/vehicle.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

namespace glider::codegen {
namespace {

struct Source {
  std::string_view name;
  std::string_view unit;
};

constexpr Source kSources[] = {
#define READING(reading, source, unit) {source, unit},
#include "runtime/imc/readings.def"
#undef READING
};

std::string wrong(const platforms::PlatformSensor& sensor, const Source* source) {
  return source == nullptr ? fmt::format("`source` of sensor `{}`: no message has `{}`",
                                         sensor.name, sensor.source)
                           : fmt::format("`unit` of sensor `{}` must be \"{}\", that of `{}`",
                                         sensor.name, source->unit, sensor.source);
}

}  // namespace

bool speaksImc(const platforms::Platform& platform) {
  return !platform.front_seats.empty() && platform.front_seats.front() == "imc";
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
  for (const platforms::PlatformSensor& sensor : platform.sensors) {
    if (sensor.source.empty()) {
      continue;
    }
    const auto* const found = std::ranges::find(kSources, sensor.source, &Source::name);
    const bool known = found != std::end(kSources);
    if (!known || found->unit != sensor.unit || imc.count == GLIDER_MOST_IMC_READINGS) {
      return support::fail(support::diagnostics::badDataFile,
                           fmt::format("platform `{}`", platform.name),
                           wrong(sensor, known ? found : nullptr));
    }
    imc.sensors[imc.count] = sensor.id;
    imc.sources[imc.count] = static_cast<uint16_t>(found - std::begin(kSources));
    ++imc.count;
  }
  return imc;
}

}  // namespace glider::codegen
