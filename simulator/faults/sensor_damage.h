// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/faults/faults.h"
#include "simulator/sensors/noise.h"

#include <map>
#include <optional>
#include <vector>

namespace glider::simulator {

/// What sensors report while they are wrong.
class SensorDamage {
 public:
  /// `seed` and `stream` are for readings that jump.
  SensorDamage(std::vector<SensorFault> faults, uint64_t seed,
               NoiseStream stream = NoiseStream::SensorJumps)
      : faults_(std::move(faults)), jumps_(seed, static_cast<uint32_t>(stream)) {}

  void setNow(double now_s) { now_s_ = now_s; }
  /// What the sensor reports instead of `truth`; empty if it reports nothing.
  std::optional<double> reading(uint16_t id, double truth);

 private:
  double jump(const SensorFault& fault);

  std::vector<SensorFault> faults_;
  Noise jumps_;
  std::map<uint16_t, double> last_;  ///< the reading of a sensor before it froze
  double now_s_ = 0;
};

}  // namespace glider::simulator
