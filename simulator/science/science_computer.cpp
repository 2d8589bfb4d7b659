// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/science/science_computer.h"

#include "hooks/protocol/numbers.h"

#include <cmath>
#include <limits>

namespace glider::simulator {

constexpr double kStartOfMission = 1.25e9;  // s since 1970: the flight controller's clock, in step

ScienceComputer::ScienceComputer(uint64_t seed, const SensorSettings& settings)
    : ctd_(seed, settings), conductivity_(settings.conductivity) {
  values_.fill(std::numeric_limits<double>::quiet_NaN());
}

void ScienceComputer::set(uint16_t id, double value) {
  // As a 4-byte sensor holds it; the clock is the only wider one.
  values_[id] = id == GLIDER_SCI_M_PRESENT_TIME ? value : hooks::asFloat32(value);
  fresh_[id] = true;
}

double ScienceComputer::get(void* self, uint16_t id, bool* fresh) {
  auto& science = *static_cast<ScienceComputer*>(self);
  const bool known = id < science.values_.size();
  *fresh = known && science.fresh_[id];
  if (!known) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  science.fresh_[id] = false;
  return science.values_[id];
}

void ScienceComputer::run(double now_s, const Water& truth, const GliderByteStream& sbc,
                          const GliderByteStream& flight) {
  set(GLIDER_SCI_M_PRESENT_TIME, kStartOfMission + now_s);
  const double temperature = ctd_.temperature(truth.temperature_degC, now_s);
  if (!std::isnan(temperature)) {
    set(GLIDER_SCI_WATER_TEMP, temperature);
    set(GLIDER_SCI_WATER_COND, conductivity_);
    set(GLIDER_SCI_WATER_PRESSURE, truth.depth_m / 10);
  }
  hookprog_.run(now_s, {this, get}, sbc, flight);
}

}  // namespace glider::simulator
