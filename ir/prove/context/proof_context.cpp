// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/context/proof_context.h"

#include "ir/prove/context/never_unknown.h"
#include "ir/prove/context/setting.h"
#include "ir/verify/whole_numbers.h"

#include <algorithm>
#include <limits>

namespace glider::ir::prove {

ProofContext::ProofContext(const Mission& asked, const platforms::Platform& vehicle)
    : mission(asked),
      platform(vehicle),
      intervals(intervalsOf(asked)),
      known(neverUnknown(asked, intervals)),
      whole(wholeExpressions(asked, intervals)),
      set_since(setSinceWatched(asked)),
      depth(depthSensor(asked, vehicle)),
      tick_gap_s(std::max(vehicle.world.tick_gap_s, asked.resume_within_s)) {
  constexpr double kMost = std::numeric_limits<double>::max();
  sensors.assign(mission.sensors.size(), {-kMost, kMost, false});
  windows.assign(mission.temporals.size(), {-kMost, kMost, false});
  for (size_t i = 0; i < mission.exprs.size(); ++i) {
    const Expr& e = mission.exprs[i];
    if (e.op == Op::Sensor) {
      sensors[e.sensor.index] = intervals[i];
    } else if (e.op == Op::Temporal) {
      windows[e.temporal.index] = intervals[i];
    }
  }
}

ProofContext ProofContext::withoutPowerCuts() const {
  ProofContext same = *this;
  same.tick_gap_s = platform.world.tick_gap_s;
  return same;
}

std::optional<SensorId> depthSensor(const Mission& mission, const platforms::Platform& platform) {
  for (uint32_t i = 0; i < mission.sensors.size(); ++i) {
    const platforms::PlatformSensor* sensor = platform.find(mission.sensors[i].vehicle_name);
    if (sensor != nullptr && sensor->alias == "depth") {
      return SensorId{i};
    }
  }
  return std::nullopt;
}

}  // namespace glider::ir::prove
