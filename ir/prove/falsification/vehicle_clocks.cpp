// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/falsification/vehicle_clocks.h"

#include "ir/prove/context/vehicle_clock.h"

#include <cmath>

namespace glider::ir::prove {

VehicleClocks::VehicleClocks(const ProofContext& proof_context) {
  for (uint32_t i = 0; i < proof_context.mission.sensors.size(); ++i) {
    if (isVehicleClock(proof_context.platformSensor({i}))) {
      sensors_.push_back({i});
    }
  }
  started_.resize(sensors_.size());
}

bool VehicleClocks::goOn(std::span<const double> readings, double time) {
  bool good = true;
  for (size_t i = 0; i < sensors_.size(); ++i) {
    const double reading = readings[sensors_[i].index];
    if (reading != reading) {
      continue;
    }
    const double start = reading - time;
    good = good && std::fabs(start - started_[i].value_or(start)) <= kTolerance_s;
    started_[i] = started_[i].value_or(start);
  }
  return good;
}

}  // namespace glider::ir::prove
