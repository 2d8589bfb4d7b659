// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/science/science_computer.h"

#include "hooks/protocol/numbers.h"
#include "simulator/slocum/clock.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glider::simulator {

ScienceComputer::ScienceComputer(const platforms::Platform& platform, uint64_t seed,
                                 const SensorSettings& settings, MakeProglet make)
    : make_proglet_(std::move(make)),
      numbers_(platform),
      dictionary_(platform),
      proglet_(make_proglet_(dictionary_.get())),
      values_(platform.sensors.size(), std::numeric_limits<double>::quiet_NaN()),
      fresh_(platform.sensors.size(), 0) {
  for (const auto& sensor : platform.sensors) {
    bytes_.push_back(sensor.bytes);
    of_flight_.push_back(sensor.computer == platforms::Computer::Flight ? 1 : 0);
  }
  for (std::unique_ptr<Instrument>& instrument : makeInstruments(seed, settings)) {
    if (instrument->carried()) {
      fit(platform, std::move(instrument));
    }
  }
}

void ScienceComputer::fit(const platforms::Platform& platform,
                          std::unique_ptr<Instrument> instrument) {
  OnBoard one;
  one.instrument = std::move(instrument);
  for (const InstrumentSensor& sensor : one.instrument->sensors()) {
    one.numbers.push_back(numberOf(platform, sensor.name));
  }
  instruments_.push_back(std::move(one));
}

void ScienceComputer::sampleEvery(const SamplePeriods& periods) {
  for (OnBoard& one : instruments_) {
    one.period_s = periods.at(one.instrument->proglet().sensor_type);
  }
}

bool ScienceComputer::reads(uint16_t id) const {
  return id == numbers_[Sensor::sci_m_present_time] ||
         std::ranges::any_of(instruments_, [id](const OnBoard& one) {
           return std::ranges::find(one.numbers, id) != one.numbers.end();
         });
}

double ScienceComputer::recorded(uint16_t id) const {
  const auto is_off = [id](const OnBoard& one) {
    return one.period_s < 0 && std::ranges::find(one.numbers, id) != one.numbers.end();
  };
  return std::ranges::any_of(instruments_, is_off) ? std::numeric_limits<double>::quiet_NaN()
                                                   : value(id);
}

void ScienceComputer::restart() {
  proglet_ = make_proglet_(dictionary_.get());
  std::ranges::fill(values_, std::numeric_limits<double>::quiet_NaN());
  std::ranges::fill(fresh_, uint8_t{0});
}

void ScienceComputer::set(uint16_t id, double value) {
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
  store(id, value);
  if (line_ != nullptr) {
    line_->to_flight.send({.id = id, .value = values_[id]});
  }
}

void ScienceComputer::store(uint16_t id, double value) {
  values_[id] = bytes_[id] == 4 ? hookAsFloat32(value) : value;
  fresh_[id] = 1;
}

/// What the flight controller has set; only its own sensors.
void ScienceComputer::receive() {
  while (const std::optional<PassingValue> one = line_->to_science.next()) {
    if (one->id < values_.size() && of_flight_[one->id] != 0) {
      store(one->id, one->value);
    }
  }
}

/// A proglet sets a sensor, which the vehicle's software takes to the flight controller.
void ScienceComputer::write(void* self, uint16_t id, double value) {
  auto& science = *static_cast<ScienceComputer*>(self);
  if (id < science.values_.size()) {
    science.store(id, value);
    science.line_->to_flight.send({.id = id, .value = science.values_[id]});
  }
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

void ScienceComputer::sample(OnBoard& one, const Sampling& at) {
  one.readings.assign(one.numbers.size(), std::numeric_limits<double>::quiet_NaN());
  one.instrument->sample(at, one.readings);
  for (size_t i = 0; i < one.readings.size(); ++i) {
    if (!std::isnan(one.readings[i])) {
      set(one.numbers[i], one.readings[i]);
    }
  }
}

void ScienceComputer::run(double now_s, const Ocean& ocean, const Place& place,
                          const GliderByteStream& sbc, FlightScienceLine& line) {
  line_ = &line;
  receive();
  set(numbers_[Sensor::sci_m_present_time], kStartOfMission + now_s);
  for (OnBoard& one : instruments_) {
    if (one.period_s >= 0 && now_s - one.sampled_s >= one.period_s) {
      one.sampled_s = now_s;
      sample(one, {now_s, place.depth_m, place.x, place.y, ocean});
    }
  }
  proglet_->run(now_s, {this, get, write}, sbc);
  line_ = nullptr;
}

}  // namespace glider::simulator
