// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/worlds/depth_sensor.h"

namespace glider::ir {

std::optional<SensorId> depthSensor(const Mission& mission, const platforms::Platform& platform) {
  for (uint32_t i = 0; i < mission.sensors.size(); ++i) {
    const platforms::PlatformSensor* sensor = platform.find(mission.sensors[i].vehicle_name);
    if (sensor != nullptr && sensor->alias == "depth") {
      return SensorId{i};
    }
  }
  return std::nullopt;
}

}  // namespace glider::ir
