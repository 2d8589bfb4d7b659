// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/science/science_computer.h"

#include "hooks/protocol/numbers.h"

#include <cmath>
#include <limits>

namespace glider::simulator {

constexpr double kStartOfMission = 1.25e9;  // s since 1970: the flight controller's clock, in step

ScienceComputer::ScienceComputer(uint64_t seed, const SensorSettings& settings, bool virtual_time)
    : ctd_(seed, settings.ctd),
      fluorometer_(seed, NoiseStream::Chlorophyll, settings.chlorophyll_ugpl),
      optode_(seed, NoiseStream::Oxygen, settings.oxygen_uM),
      virtual_time_(virtual_time),
      hookprog_({.virtual_time = virtual_time}) {
  values_.fill(std::numeric_limits<double>::quiet_NaN());
}

void ScienceComputer::restart() {
  hookprog_ = hooks::Hookprog({.virtual_time = virtual_time_});
  values_.fill(std::numeric_limits<double>::quiet_NaN());
  fresh_.fill(false);
}

void ScienceComputer::set(uint16_t id, double value) {
  if (damage_ != nullptr) {
    const std::optional<double> reading = damage_->reading(id, value);
    if (!reading) {
      return;
    }
    value = *reading;
  }
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

void ScienceComputer::readCtd(double now_s, const Ocean& ocean, const Place& place) {
  const auto water = [&](double depth_m) {
    return ocean.temperature(depth_m, place.x, place.y, now_s);
  };
  if (const auto reading = ctd_.read(water, place.depth_m, now_s)) {
    set(GLIDER_SCI_WATER_TEMP, reading->temperature_degC);
    set(GLIDER_SCI_WATER_COND, reading->conductivity);
    set(GLIDER_SCI_WATER_PRESSURE, reading->depth_m / 10);
  }
}

void ScienceComputer::run(double now_s, const Ocean& ocean, const Place& place,
                          const GliderByteStream& sbc, const GliderByteStream& flight) {
  set(GLIDER_SCI_M_PRESENT_TIME, kStartOfMission + now_s);
  readCtd(now_s, ocean, place);
  // A vehicle in water of which the scenario says nothing does not carry the sensor.
  const double chlorophyll = ocean.chlorophyll(place.depth_m, place.x, place.y);
  if (!std::isnan(chlorophyll)) {
    set(GLIDER_SCI_FLBBCD_CHLOR_UNITS, fluorometer_.read(chlorophyll));
  }
  const double oxygen = ocean.oxygen(place.depth_m, place.x, place.y, now_s);
  if (!std::isnan(oxygen)) {
    set(GLIDER_SCI_OXY4_OXYGEN, optode_.read(oxygen));
  }
  hookprog_.run(now_s, {this, get}, sbc, flight);
}

}  // namespace glider::simulator
