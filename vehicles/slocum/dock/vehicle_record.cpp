// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/dock/vehicle_record.h"

#include "hooks/extctl/pairs.h"
#include "hooks/extctl/sentence.h"
#include "vehicles/slocum/dock/dock_run.h"

#include <algorithm>
#include <cmath>

namespace glider::slocum {
namespace {

/// Of a position that the vehicle does not have yet.
constexpr double kNoPosition = 69696969;

bool isDegreesMinutes(double value) {
  return std::fmod(std::fabs(value), 100) < 60;
}

}  // namespace

VehicleRecord::VehicleRecord(const DockSetup& setup) : setup_(&setup) {
  const size_t first = setup.sensors.parameters.size() + setup.sensors.written.size();
  for (const ExtctlSensor& sensor : setup.sensors.sensors()) {
    sensors.push_back(
        {.sensor = sensor, .is_reported = sensors.size() >= first, .implausible = {}});
  }
}

size_t VehicleRecord::indexOf(const std::string& name) const {
  const auto found = std::ranges::find_if(
      sensors, [&](const ReportedSensor& one) { return one.sensor.name == name; });
  return static_cast<size_t>(found - sensors.begin());
}

double VehicleRecord::value(const std::string& name) const {
  const size_t index = indexOf(name);
  return index < sensors.size() ? sensors[index].newest : std::numeric_limits<double>::quiet_NaN();
}

void VehicleRecord::take(const std::string& body, double now_s) {
  const std::string name = nameOf(body);
  cycle_bytes_ += static_cast<uint32_t>(body.size()) + hooks::extctl::kSentenceEnd + 1;
  if (name == "SD") {
    newest_report_s = now_s;
    takeReport(body, now_s);
  } else if (name == "HI") {
    hellos_s.push_back(now_s);
  } else if (name == "BY") {
    byes_s.push_back(now_s);
  }
  sbc_is_there = sbc_is_there || isOfSbc(name);
}

void VehicleRecord::takeReport(const std::string& body, double now_s) {
  constexpr uint32_t kName = 2;
  const double clock = sensors.empty() ? 0 : sensors.back().newest;
  hooks::extctl::PairReader reader(body.data() + kName, static_cast<uint32_t>(body.size()) - kName);
  for (hooks::extctl::Pair pair; reader.next(&pair);) {
    if (!pair.good) {
      ++bad_pairs;
    } else if (pair.index >= sensors.size() || !sensors[pair.index].is_reported) {
      unknown.insert(pair.index);
    } else {
      takeValue(pair.index, pair.value);
    }
  }
  const double newest = sensors.empty() ? clock : sensors.back().newest;
  if (!std::isnan(newest) && newest != clock) {
    cycles.push_back({now_s, newest});
    most_cycle_bytes = std::max(most_cycle_bytes, cycle_bytes_);
    cycle_bytes_ = 0;
  }
}

void VehicleRecord::takeValue(uint32_t index, double value) {
  ReportedSensor& one = sensors[index];
  ++one.reports;
  one.newest = value;
  if (!one.implausible && !isPlausible(one.sensor, value)) {
    one.implausible = value;
  }
}

bool VehicleRecord::isPlausible(const ExtctlSensor& sensor, double value) const {
  const platforms::PlatformSensor* known = setup_->platform.find(sensor.name);
  if (std::isnan(value) || std::fabs(value) == kNoPosition) {
    return true;  // it has no value yet
  }
  if (known == nullptr) {
    const bool is_truth = sensor.unit == "bool";
    return value == std::floor(value) && value >= 0 && value < (is_truth ? 2 : 1e6);
  }
  const bool place = known->kind != platforms::SensorKind::Quantity;
  return value >= known->lowest && value <= known->highest && (!place || isDegreesMinutes(value));
}

}  // namespace glider::slocum
