// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <map>

namespace glider::simulator {

/// How often each instrument of the science bay samples: by the sensor_type of its proglet, seconds
/// between two readings. 0: in each cycle of the science computer; negative: it is off.
class SamplePeriods {
 public:
  void set(int sensor_type, double seconds) { seconds_[sensor_type] = seconds; }
  /// 0 for an instrument that nothing was said of.
  [[nodiscard]] double at(int sensor_type) const {
    const auto found = seconds_.find(sensor_type);
    return found == seconds_.end() ? 0 : found->second;
  }

 private:
  std::map<int, double> seconds_;
};

}  // namespace glider::simulator
