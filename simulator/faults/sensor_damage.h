// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/faults/faults.h"

#include <map>
#include <optional>
#include <vector>

namespace glider::simulator {

/// What sensors say while they are wrong.
class SensorDamage {
 public:
  explicit SensorDamage(std::vector<SensorFault> faults) : faults_(std::move(faults)) {}

  void setNow(double now_s) { now_s_ = now_s; }
  /// What the sensor gives instead of `truth`; nothing if it gives nothing.
  std::optional<double> reading(uint16_t id, double truth);

 private:
  std::vector<SensorFault> faults_;
  std::map<uint16_t, double> last_;  ///< that a sensor gave before it froze
  double now_s_ = 0;
};

}  // namespace glider::simulator
