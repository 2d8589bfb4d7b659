// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/dock/dock.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace glider::slocum {

/// A sensor of the list as the vehicle has reported it.
struct ReportedSensor {
  ExtctlSensor sensor;
  bool is_reported = false;  ///< by the list: the SBC does not write it
  uint32_t reports = 0;
  double newest = std::numeric_limits<double>::quiet_NaN();
  std::optional<double> implausible;  ///< the first value that the sensor cannot have
};

/// What a vehicle has said.
class VehicleRecord {
 public:
  explicit VehicleRecord(const DockSetup& setup);

  /// Takes the body of a sentence that arrived at `now_s`.
  void take(const std::string& body, double now_s);
  /// The newest value of a sensor; NaN before its first report, or if the list lacks it.
  [[nodiscard]] double value(const std::string& name) const;
  /// Its index; the size of `sensors` if the list lacks it.
  [[nodiscard]] size_t indexOf(const std::string& name) const;

  /// A control cycle, which ends with the vehicle's clock.
  struct Cycle {
    double at_s;     ///< when it arrived
    double clock_s;  ///< of the vehicle
  };
  std::vector<ReportedSensor> sensors;  ///< by index
  std::vector<Cycle> cycles;
  std::set<uint32_t> unknown;  ///< indices that the list does not have, or that the SBC writes
  uint32_t bad_pairs = 0;
  std::vector<double> hellos_s, byes_s;  ///< when its end of the port began and ended
  double newest_report_s = -1;
  uint32_t most_cycle_bytes = 0;  ///< in the sentences of a control cycle
  bool sbc_is_there = false;      ///< a sentence that only an SBC says

 private:
  void takeReport(const std::string& body, double now_s);
  void takeValue(uint32_t index, double value);
  [[nodiscard]] bool isPlausible(const ExtctlSensor& sensor, double value) const;

  const DockSetup* setup_;
  uint32_t cycle_bytes_ = 0;
};

}  // namespace glider::slocum
