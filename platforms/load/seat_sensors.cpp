// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "platforms/load/seat_sensors.h"

#include "platforms/load/sensor_unit.h"
#include "support/check.h"

#include <algorithm>

namespace glider::platforms {
namespace {

struct Row {
  const char* role;
  const char* name;
  const char* unit;
  double lowest, highest;
  uint8_t bytes;
  bool science, counts;
  const char* what;
};

constexpr Row kRows[] = {
#define SEAT_SENSOR(role, name, unit, lowest, highest, bytes, science, counts, what) \
  {#role, name, unit, lowest, highest, bytes, science, counts, what},
#include "platforms/load/seat_sensors.def"
#undef SEAT_SENSOR
};

/// As long as the Slocum's readings count.
constexpr double kStale_s = 20;

PlatformSensor sensorOf(const Row& row, const Platform& platform) {
  PlatformSensor sensor;
  sensor.id = static_cast<uint16_t>(platform.sensors.size());
  sensor.name = row.name;
  sensor.role = row.role;
  sensor.unit = row.unit;
  CHECK(interpretUnit(sensor), "a sensor of the seat has no unit");
  sensor.lowest = row.lowest;
  sensor.highest = row.highest;
  sensor.stale_after_s = kStale_s;
  sensor.every_s = platform.envelope.cycle_s;
  sensor.computer = row.science ? Computer::Science : Computer::Flight;
  sensor.bytes = row.bytes;
  sensor.what = row.what;
  sensor.counts = row.counts;
  return sensor;
}

}  // namespace

void addSeatSensors(Platform& platform) {
  for (const Row& row : kRows) {
    if (std::ranges::find(platform.sensors, row.role, &PlatformSensor::role) ==
        platform.sensors.end()) {
      platform.sensors.push_back(sensorOf(row, platform));
    }
  }
}

}  // namespace glider::platforms
