// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/faults/faults.h"
#include "simulator/sensors/noise.h"

#include <map>
#include <optional>
#include <vector>

namespace glider::simulator {

/// What sensors say while they are wrong.
class SensorDamage {
 public:
  /// `seed`: of readings that jump.
  SensorDamage(std::vector<SensorFault> faults, uint64_t seed)
      : faults_(std::move(faults)), jumps_(seed, static_cast<uint32_t>(NoiseStream::SensorJumps)) {}

  void setNow(double now_s) { now_s_ = now_s; }
  /// What the sensor gives instead of `truth`; nothing if it gives nothing.
  std::optional<double> reading(uint16_t id, double truth);

 private:
  double jump(const SensorFault& fault);

  std::vector<SensorFault> faults_;
  Noise jumps_;
  std::map<uint16_t, double> last_;  ///< that a sensor gave before it froze
  double now_s_ = 0;
};

}  // namespace glider::simulator
