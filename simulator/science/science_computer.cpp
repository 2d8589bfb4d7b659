// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/science/science_computer.h"

#include "hooks/protocol/numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glider::simulator {

constexpr double kStartOfMission = 1.25e9;  // s since 1970: the flight controller's clock, in step

ScienceComputer::ScienceComputer(const platforms::Platform& platform, uint64_t seed,
                                 const SensorSettings& settings, bool virtual_time)
    : ctd_(seed, settings.ctd),
      fluorometer_(seed, NoiseStream::Chlorophyll, settings.chlorophyll_ugpl),
      optode_(seed, NoiseStream::Oxygen, settings.oxygen_uM),
      virtual_time_(virtual_time),
      numbers_(platform),
      dictionary_(platform),
      hookprog_(dictionary_.get(), {.virtual_time = virtual_time}),
      values_(platform.sensors.size(), std::numeric_limits<double>::quiet_NaN()),
      fresh_(platform.sensors.size(), 0) {}

void ScienceComputer::restart() {
  hookprog_ = hooks::Hookprog(dictionary_.get(), {.virtual_time = virtual_time_});
  std::ranges::fill(values_, std::numeric_limits<double>::quiet_NaN());
  std::ranges::fill(fresh_, uint8_t{0});
}

void ScienceComputer::set(Sensor sensor, double value) {
  const uint16_t id = numbers_[sensor];
  if (id >= values_.size()) {
    return;  // the vehicle does not carry it
  }
  if (damage_ != nullptr) {
    const std::optional<double> reading = damage_->reading(id, value);
    if (!reading) {
      return;
    }
    value = *reading;
  }
  // As a 4-byte sensor holds it; the clock is the only wider one.
  values_[id] = sensor == Sensor::sci_m_present_time ? value : hooks::asFloat32(value);
  fresh_[id] = 1;
}

double ScienceComputer::get(void* self, uint16_t id, bool* fresh) {
  auto& science = *static_cast<ScienceComputer*>(self);
  const bool known = id < science.values_.size();
  *fresh = known && science.fresh_[id] != 0;
  if (!known) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  science.fresh_[id] = 0;
  return science.values_[id];
}

void ScienceComputer::readCtd(double now_s, const Ocean& ocean, const Place& place) {
  const auto water = [&](double depth_m) {
    return ocean.temperature(depth_m, place.x, place.y, now_s);
  };
  if (const auto reading = ctd_.read(water, place.depth_m, now_s)) {
    set(Sensor::sci_water_temp, reading->temperature_degC);
    set(Sensor::sci_water_cond, reading->conductivity);
    set(Sensor::sci_water_pressure, reading->depth_m / 10);
  }
}

void ScienceComputer::run(double now_s, const Ocean& ocean, const Place& place,
                          const GliderByteStream& sbc, const GliderByteStream& flight) {
  set(Sensor::sci_m_present_time, kStartOfMission + now_s);
  readCtd(now_s, ocean, place);
  // A vehicle in water of which the scenario says nothing does not carry the sensor.
  const double chlorophyll = ocean.chlorophyll(place.depth_m, place.x, place.y);
  if (!std::isnan(chlorophyll)) {
    set(Sensor::sci_flbbcd_chlor_units, fluorometer_.read(chlorophyll));
  }
  const double oxygen = ocean.oxygen(place.depth_m, place.x, place.y, now_s);
  if (!std::isnan(oxygen)) {
    set(Sensor::sci_oxy4_oxygen, optode_.read(oxygen));
  }
  hookprog_.run(now_s, {this, get}, sbc, flight);
}

}  // namespace glider::simulator
