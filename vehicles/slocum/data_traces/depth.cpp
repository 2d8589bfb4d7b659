// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/data_traces/depth.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace glider::slocum {
namespace {

/// Short messages by satellite contain m_depth rarely and another sensor often.
constexpr double kWhile = 30;  // s

struct DepthSensor {
  const char* name;
  const char* unit;
  double metres;  ///< for each unit of the sensor
};

// The vehicle computes m_depth from m_pressure with the same factor, and 0 above the surface.
constexpr DepthSensor kSensors[] = {
    {"m_depth", "m", 1}, {"m_pressure", "bar", 10}, {"sci_water_pressure", "bar", 10}};

using Sample = std::pair<double, double>;  // time and depth

/// Adds those of `samples` that are not within kWhile of one in `depths`, which is sorted.
std::vector<Sample> filled(const std::vector<Sample>& depths, const Samples& samples,
                           double metres) {
  std::vector<Sample> all = depths;
  for (size_t i = 0; i < samples.times_s.size(); ++i) {
    const double time = samples.times_s[i], value = samples.values[i];
    const auto near = std::ranges::lower_bound(depths, time - kWhile, {}, &Sample::first);
    if (!std::isnan(value) && (near == depths.end() || near->first > time + kWhile)) {
      all.emplace_back(time, std::max(0.0, value * metres));
    }
  }
  std::ranges::sort(all);
  return all;
}

}  // namespace

std::vector<std::string> depthSensors() {
  std::vector<std::string> names;
  for (const DepthSensor& sensor : kSensors) {
    names.emplace_back(sensor.name);
  }
  return names;
}

Samples depthOf(const Merged& merged) {
  std::vector<Sample> depths;
  for (const DepthSensor& sensor : kSensors) {
    depths = filled(depths, samplesOf(merged, sensor.name, sensor.unit), sensor.metres);
  }
  Samples samples;
  for (const auto& [time, depth] : depths) {
    samples.times_s.push_back(time);
    samples.values.push_back(depth);
  }
  return samples;
}

}  // namespace glider::slocum
