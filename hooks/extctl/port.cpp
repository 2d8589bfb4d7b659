// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/extctl/port.h"

namespace glider::hooks::extctl {

Port::Port(const GliderDictionary& dictionary, const Subscription* sensors, uint32_t count) {
  constexpr GliderRole kOwn[] = {kGliderRoleMissionTime, kGliderRoleMagneticVariation};
  const uint16_t clock = sensorOf(dictionary, kGliderRoleClock);
  for (const GliderRole role : kOwn) {
    add(sensorOf(dictionary, role));
  }
  for (uint32_t i = 0; i < count; ++i) {
    if (sensors[i].id != clock) {
      add(sensors[i].id);
    }
  }
  add(clock);
}

void Port::add(uint16_t sensor) {
  if (sensor == kNoSensor || indexOf(sensor) < this->count()) {
    return;
  }
  fits_ = fits_ && count_ < kMostSensors - kFixedSensors;
  if (fits_) {
    sensors_[count_++] = sensor;
  }
}

uint32_t Port::indexOf(uint16_t sensor) const {
  for (uint32_t i = 0; i < count_; ++i) {
    if (sensors_[i] == sensor) {
      return kFixedSensors + i;
    }
  }
  return count();
}

}  // namespace glider::hooks::extctl
