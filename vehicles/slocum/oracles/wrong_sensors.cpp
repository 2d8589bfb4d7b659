// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/oracles/wrong_sensors.h"

#include <algorithm>

namespace glider::slocum::oracles {

namespace {

bool hasEffect(const SensorFault& fault, double now_s, double fades_s) {
  return now_s >= fault.when.from_s && now_s < fault.when.to_s + fades_s;
}

}  // namespace

bool anyWrong(const Faults& faults, double now_s, double fades_s) {
  return std::ranges::any_of(
      faults.sensors, [&](const SensorFault& fault) { return hasEffect(fault, now_s, fades_s); });
}

bool isWrong(const Faults& faults, std::initializer_list<std::string_view> sensors, double now_s,
             double fades_s) {
  return std::ranges::any_of(faults.sensors, [&](const SensorFault& fault) {
    return std::ranges::find(sensors, fault.name) != sensors.end() &&
           hasEffect(fault, now_s, fades_s);
  });
}

bool isSeldom(const Faults& faults, std::initializer_list<std::string_view> sensors, double now_s,
              double fades_s) {
  return std::ranges::any_of(faults.sensors, [&](const SensorFault& fault) {
    return std::ranges::find(sensors, fault.name) != sensors.end() &&
           fault.kind == SensorFault::Kind::Missing && fault.share < 1 &&
           hasEffect(fault, now_s, fades_s);
  });
}

}  // namespace glider::slocum::oracles
