// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/faults/sensor_damage.h"

#include <cmath>
#include <numbers>

namespace glider::simulator {

double SensorDamage::jump(const SensorFault& fault) {
  const bool jumps = jumps_.uniform() < fault.share;
  const double by = fault.value * (2 * jumps_.uniform() - 1);
  return jumps ? by : 0;
}

std::optional<double> SensorDamage::reading(uint16_t id, double truth) {
  double reading = truth;
  bool frozen = false;
  for (const SensorFault& fault : faults_) {
    if (fault.id != id || !fault.when.has(now_s_)) {
      continue;
    }
    switch (fault.kind) {
      case SensorFault::Kind::Missing:
        if (jumps_.uniform() < fault.share) {
          return std::nullopt;
        }
        break;
      case SensorFault::Kind::Value:
        reading = fault.share >= 1 || jumps_.uniform() < fault.share ? fault.value : reading;
        break;
      case SensorFault::Kind::Drift:
        reading += fault.value * (now_s_ - fault.when.from_s);
        break;
      case SensorFault::Kind::Offset:
        reading += fault.value;
        break;
      case SensorFault::Kind::Scale:
        reading *= fault.value;
        break;
      case SensorFault::Kind::Sways:
        reading += fault.value *
                   std::sin(2 * std::numbers::pi * (now_s_ - fault.when.from_s) / fault.period_s);
        break;
      case SensorFault::Kind::Jumps:
        reading += jump(fault);
        break;
      case SensorFault::Kind::Frozen:
        frozen = true;
        reading = last_.try_emplace(id, truth).first->second;
        break;
    }
  }
  if (!frozen) {
    last_[id] = reading;
  }
  return reading;
}

}  // namespace glider::simulator
