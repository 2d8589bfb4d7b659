// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/depths/depth_faults.h"

#include <fmt/format.h>

#include <cmath>
#include <set>

namespace glider::tests {
namespace {

using simulator::SensorFault;
using Kind = SensorFault::Kind;

SensorFault fault(const std::string& sensor, Kind kind, double value = 0, double share = 1) {
  SensorFault out;
  out.name = sensor;
  out.kind = kind;
  out.value = value;
  out.share = share;
  return out;
}

/// A sensor with values that it might give, how far it may jump, and how it may drift a second.
struct Sensor {
  const char* name;
  std::vector<double> values;
  double jump, drift;
};

/// Over a bottom within its range, which the other flights do not have.
const Sensor& altimeter() {
  static const Sensor kAltimeter = {"m_altitude", {3, 50}, 30, 0.02};
  return kAltimeter;
}

const std::vector<Sensor>& sensors() {
  static const std::vector<Sensor> kSensors = {
      {"m_depth", {0, 5, 25, 50, -50, 1e9}, 20, 0.02},
      {"m_pressure", {0, 2.5, -3, 100}, 2, 0.002},
      {"m_depth_rate", {0, -0.2, 0.2, 2, -2}, 1, 0.001},
      {"m_pitch", {0, 0.45, -0.45, 1.5, -1.5}, 1, 0.001},
      {"m_heading", {0, 3}, 3, 0.001},
      {"m_ballast_pumped", {0, 230, -230}, 200, 0.1},
      {"m_battpos", {0, 1.4}, 1, 0.001},
      {"m_present_secs_into_mission", {0, 60000, -1e9}, 5000, 0.5},
      {"m_present_time", {0, 2e9}, 1e6, 0.5},
      {"m_cycle_number", {0, 1e7}, 1e5, 0.5},
      {"m_lat", {0, 9000}, 100, 0.01},
      {"sci_water_pressure", {0, 2.5, 5, -3, 100}, 2, 0.002}};
  return kSensors;
}

/// Stuck, but not to the last bit; and with readings left out.
void addFlickers(const Sensor& sensor, std::vector<DepthFault>& out) {
  const SensorFault stuck = fault(sensor.name, Kind::Frozen);
  const SensorFault flickers = fault(sensor.name, Kind::Jumps, sensor.jump / 2000, 0.7);
  const SensorFault wavers = fault(sensor.name, Kind::Jumps, sensor.jump / 50, 0.7);
  const std::string name = sensor.name;
  out.push_back({name + " flickers", DepthRule::Wrong, {stuck, flickers}});
  out.push_back({name + " wavers", DepthRule::Wrong, {stuck, wavers}});
  for (const double share : {0.1, 0.25, 0.5}) {
    out.push_back({fmt::format("{} flickers, {} missing", name, share),
                   DepthRule::Wrong,
                   {stuck, flickers, fault(sensor.name, Kind::Missing, 0, share)}});
  }
  for (const double share : {0.25, 0.9}) {
    out.push_back({fmt::format("{} missing {}", name, share),
                   DepthRule::Wrong,
                   {fault(sensor.name, Kind::Missing, 0, share)}});
  }
}

std::string nameOf(const SensorFault& f) {
  return f.kind == Kind::Frozen    ? f.name + " frozen"
         : f.kind == Kind::Missing ? f.name + " missing"
         : f.kind == Kind::Jumps   ? f.name + " jumps"
         : f.kind == Kind::Scale   ? fmt::format("{} times {}", f.name, f.value)
                                   : fmt::format("{} = {}", f.name, f.value);
}

/// A slow sine, added to the truth or to a reading that is stuck.
void addSways(const Sensor& sensor, std::vector<DepthFault>& out) {
  for (const double period_s : {40.0, 100.0, 200.0}) {
    SensorFault sways = fault(sensor.name, Kind::Sways, sensor.jump / 10);
    sways.period_s = period_s;
    const std::string name = fmt::format("{} sways in {} s", sensor.name, period_s);
    out.push_back({name, DepthRule::False, {sways}});
    out.push_back({name + ", stuck", DepthRule::False, {fault(sensor.name, Kind::Frozen), sways}});
  }
}

void addAll(const Sensor& sensor, std::vector<DepthFault>& out) {
  const auto add = [&](const std::string& how, DepthRule rule, const SensorFault& what) {
    out.push_back({fmt::format("{} {}", sensor.name, how), rule, {what}});
  };
  add("frozen", DepthRule::Wrong, fault(sensor.name, Kind::Frozen));
  add("missing", DepthRule::Wrong, fault(sensor.name, Kind::Missing));
  add("nan", DepthRule::Wrong, fault(sensor.name, Kind::Value, std::nan("")));
  for (const double value : sensor.values) {
    add(fmt::format("= {}", value), DepthRule::Wrong, fault(sensor.name, Kind::Value, value));
  }
  for (const double share : {0.05, 0.5, 1.0}) {
    add(fmt::format("jumps {} {}", sensor.jump, share), DepthRule::Wrong,
        fault(sensor.name, Kind::Jumps, sensor.jump, share));
  }
  for (const double drift : {-sensor.drift, sensor.drift}) {
    add(fmt::format("drifts {}/s", drift), DepthRule::False,
        fault(sensor.name, Kind::Drift, drift));
  }
  for (const double scale : {0.5, 0.8, 0.9, 1.2}) {
    add(fmt::format("times {}", scale), DepthRule::False, fault(sensor.name, Kind::Scale, scale));
  }
  addFlickers(sensor, out);
  addSways(sensor, out);
}

}  // namespace

simulator::Faults DepthFault::from(double begin_s) const {
  simulator::Faults faults;
  faults.sensors = sensors;
  for (SensorFault& sensor : faults.sensors) {
    sensor.when = {begin_s, simulator::kForever};
  }
  return faults;
}

std::vector<DepthFault> DepthFault::parts() const {
  std::vector<DepthFault> out;
  std::set<std::string> names;
  for (const SensorFault& sensor : sensors) {
    names.insert(sensor.name);
  }
  for (const std::string& one : names) {
    DepthFault part = *this;
    std::erase_if(part.sensors, [&](const SensorFault& sensor) { return sensor.name == one; });
    out.push_back(part);
  }
  return out;
}

std::vector<DepthFault> singleDepthFaults() {
  std::vector<DepthFault> out;
  for (const Sensor& sensor : sensors()) {
    addAll(sensor, out);
  }
  return out;
}

std::vector<DepthFault> altimeterFaults() {
  std::vector<DepthFault> out;
  addAll(altimeter(), out);
  out.push_back({"m_altitude plus 20", DepthRule::Wrong, {fault("m_altitude", Kind::Offset, 20)}});
  for (const DepthFault& one : {DepthFault{"missing", {}, {fault("m_altitude", Kind::Missing)}},
                                DepthFault{"= 50", {}, {fault("m_altitude", Kind::Value, 50)}}}) {
    const SensorFault others[] = {fault("m_depth", Kind::Frozen),
                                  fault("m_pitch", Kind::Value, 1.5),
                                  fault("sci_water_pressure", Kind::Missing)};
    for (const SensorFault& other : others) {
      out.push_back({fmt::format("m_altitude {}, {}", one.name, nameOf(other)),
                     DepthRule::Two,
                     {one.sensors.front(), other}});
    }
  }
  return out;
}

std::vector<DepthFault> doubleDepthFaults() {
  const std::vector<SensorFault> parts = {fault("m_depth", Kind::Frozen),
                                          fault("m_depth", Kind::Value, 5),
                                          fault("m_depth", Kind::Jumps, 20, 0.5),
                                          fault("m_depth", Kind::Scale, 0.8),
                                          fault("sci_water_pressure", Kind::Frozen),
                                          fault("sci_water_pressure", Kind::Missing),
                                          fault("sci_water_pressure", Kind::Value, 0.5),
                                          fault("sci_water_pressure", Kind::Scale, 0.8),
                                          fault("m_pitch", Kind::Value, 1.5),
                                          fault("m_pitch", Kind::Frozen),
                                          fault("m_depth_rate", Kind::Value, -2),
                                          fault("m_present_secs_into_mission", Kind::Frozen),
                                          fault("m_present_secs_into_mission", Kind::Value, 60000),
                                          fault("m_cycle_number", Kind::Frozen)};
  std::vector<DepthFault> out;
  for (size_t i = 0; i < parts.size(); ++i) {
    for (size_t k = i + 1; k < parts.size(); ++k) {
      if (parts[i].name != parts[k].name) {
        out.push_back(
            {nameOf(parts[i]) + ", " + nameOf(parts[k]), DepthRule::Two, {parts[i], parts[k]}});
      }
    }
  }
  return out;
}

SensorFault noCtd() {
  return fault("sci_water_pressure", Kind::Missing);
}

}  // namespace glider::tests
