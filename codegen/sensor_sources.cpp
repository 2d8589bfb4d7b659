// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/sensor_sources.h"

#include "support/diagnostics/ids/vehicle.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace glider::codegen {
namespace {

std::string wrong(const platforms::PlatformSensor& sensor, const SensorSource* source) {
  return source == nullptr ? fmt::format("`source` of sensor `{}`: no message has `{}`",
                                         sensor.name, sensor.source)
                           : fmt::format("`unit` of sensor `{}` must be \"{}\", that of `{}`",
                                         sensor.name, source->unit, sensor.source);
}

}  // namespace

bool speaks(const platforms::Platform& platform, std::string_view front_seat) {
  return !platform.front_seats.empty() && platform.front_seats.front() == front_seat;
}

support::Result<uint32_t> readSources(const platforms::Platform& platform,
                                      std::span<const SensorSource> known,
                                      std::span<uint16_t> sensors, std::span<uint16_t> sources) {
  uint32_t count = 0;
  for (const platforms::PlatformSensor& sensor : platform.sensors) {
    if (sensor.source.empty()) {
      continue;
    }
    const auto found = std::ranges::find(known, sensor.source, &SensorSource::name);
    const bool is_known = found != known.end();
    if (!is_known || found->unit != sensor.unit || count == sensors.size()) {
      return support::fail(support::diagnostics::badDataFile,
                           fmt::format("platform `{}`", platform.name),
                           wrong(sensor, is_known ? &*found : nullptr));
    }
    sensors[count] = sensor.id;
    sources[count] = static_cast<uint16_t>(found - known.begin());
    ++count;
  }
  return count;
}

}  // namespace glider::codegen
