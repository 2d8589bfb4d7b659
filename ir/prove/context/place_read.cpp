// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/context/place_read.h"

#include "ir/prove/context/sensors_read.h"

namespace glider::ir::prove {

PlaceRead placeReadBy(const Sensor& sensor, const platforms::Platform& platform) {
  if (!sensor.symbol.empty() || sensor.encoding != Encoding::DegreesMinutes) {
    return PlaceRead::Nothing;
  }
  const platforms::PlatformSensor* row = platform.find(sensor.vehicle_name);
  if (row == nullptr) {
    return PlaceRead::Nothing;
  }
  return row->alias == "lat"   ? PlaceRead::Latitude
         : row->alias == "lon" ? PlaceRead::Longitude
                               : PlaceRead::Nothing;
}

bool isAboutPlace(const Requirement& requirement, const ProofContext& proof_context) {
  if (requirement.kind != RequirementKind::Always || !requirement.geofences.empty() ||
      !requirement.condition.valid()) {
    return false;
  }
  const Mission& m = proof_context.mission;
  bool north = false, east = false;
  forEachSensorRead(m, requirement.condition, [&](SensorId sensor) {
    const PlaceRead read = placeReadBy(m[sensor], proof_context.platform);
    north = north || read == PlaceRead::Latitude;
    east = east || read == PlaceRead::Longitude;
  });
  return north && east;
}

}  // namespace glider::ir::prove
