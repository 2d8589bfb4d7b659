// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "platforms/load/sensor_unit.h"

namespace glider::platforms {

bool interpretUnit(PlatformSensor& sensor) {
  if (sensor.unit == "lat" || sensor.unit == "lon") {
    sensor.kind = sensor.unit == "lat" ? SensorKind::Latitude : SensorKind::Longitude;
    return true;
  }
  if (sensor.unit == "1" || sensor.unit == "timestamp") {
    sensor.dimension = sensor.unit == "1" ? support::dimension::number : support::dimension::time;
    return true;
  }
  const auto unit = support::parseUnit(sensor.unit);
  if (unit) {
    sensor.dimension = unit->dimension;
    sensor.to_si = unit->to_si;
  }
  return unit.has_value();
}

}  // namespace glider::platforms
