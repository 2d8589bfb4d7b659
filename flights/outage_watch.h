// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace glider::flights {

/// The time without ticks that a restart of the SBC ends.
struct Outage {
  double from_s = 0;        ///< mission time
  double to_s = 0;          ///< mission time
  double vehicle_time = 0;  ///< of its end, s
  uint32_t state = 0;       ///< number of the current state then
};

/// Finds the outages after which an SBC continues its mission.
class OutageWatch {
 public:
  /// After each poll of the SBC. `start` counts how often it has started, from 1 on; `mission_time`
  /// is in s: after a restart it may be that of the checkpoint until the first tick. An SBC that
  /// begins its mission again has an earlier one.
  void look(size_t start, double mission_time, double vehicle_time, uint32_t state);
  [[nodiscard]] const std::vector<Outage>& found() const { return found_; }

 private:
  std::vector<Outage> found_;
  double latest_ = 0;  ///< mission time of the mission's latest tick, s
  double shown_ = 0;   ///< mission time at the first poll after the restart, s
  size_t latest_start_ = 0;
  bool restarted_ = false;  ///< and there has been no tick since
};

}  // namespace glider::flights
