// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/flight/science_switches.h"

#include "hooks/protocol/sampling.h"
#include "simulator/sensors/sensor_list.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace glider::simulator {
namespace {

constexpr std::string_view kTogether = "c_science_all_on_enabled", kAll = "c_science_all_on";
constexpr int kAllTypes = 0;

std::string switchOf(const Proglet& proglet) {
  return "c_" + std::string(proglet.name) + "_on";
}

/// The shorter of two periods; a negative one counts as none.
double fastest(double a, double b) {
  return a < 0 ? b : b < 0 ? a : std::min(a, b);
}

}  // namespace

bool isScienceSwitch(std::string_view name) {
  return name == kTogether || name == kAll ||
         std::ranges::any_of(simulatedProglets(),
                             [name](const Proglet& proglet) { return switchOf(proglet) == name; });
}

SamplePeriods samplePeriods(const std::vector<SampleOrder>& orders,
                            const MissionVariables& variables) {
  const bool together = variables.find(kTogether).value_or(1) != 0;
  SamplePeriods periods;
  for (const Proglet& proglet : simulatedProglets()) {
    std::optional<double> ordered;
    for (const SampleOrder& order : orders) {
      if (together || order.sensor_type == kAllTypes || order.sensor_type == proglet.sensor_type) {
        ordered = fastest(ordered.value_or(-1), order.period_s);
      }
    }
    const auto set = variables.find(together ? std::string(kAll) : switchOf(proglet));
    periods.set(proglet.sensor_type, ordered ? *ordered : set.value_or(0));
  }
  return periods;
}

void orderSamples(uint32_t word, const std::vector<platforms::Instrument>& instruments,
                  SamplePeriods& periods) {
  for (uint32_t place = 0; place < instruments.size(); ++place) {
    const double seconds = hookSamplingSecs(hookSamplingOf(word, place));
    const auto proglet =
        std::ranges::find(simulatedProglets(), instruments[place].vehicle_name, switchOf);
    if (!std::isnan(seconds) && proglet != simulatedProglets().end()) {
      periods.set(proglet->sensor_type, seconds);
    }
  }
}

}  // namespace glider::simulator
