// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/campaign/draw_faults.h"

#include "simulator/sensors/noise.h"

#include <array>
#include <cmath>

namespace glider::simulator {
namespace {

/// Sensors that missions and hookbeh live by; the vehicle's own clock among them.
constexpr std::array<const char*, 8> kSensors = {
    "m_depth",        "m_pitch",  "m_heading", "m_altitude", "m_lat", "m_present_secs_into_mission",
    "sci_water_temp", "m_battery"};
/// Readings that no sensor of them gives.
constexpr std::array<double, 6> kNonsense = {-1e9, -50, 1e-30, 180, 5000, 1e30};

class Draw {
 public:
  Draw(uint64_t seed, double flight_s)
      : noise_(seed, static_cast<uint32_t>(NoiseStream::Campaign)), flight_s_(flight_s) {}

  void add(FaultKind kind, Faults& faults);

 private:
  double between(double low, double high) { return low + (high - low) * noise_.uniform(); }
  /// Each power of ten is as likely.
  double scale(double low, double high) { return low * std::pow(high / low, noise_.uniform()); }
  bool chance(double share) { return noise_.uniform() < share; }
  uint32_t below(uint32_t count) { return static_cast<uint32_t>(noise_.uniform() * count); }

  double moment() { return between(0, flight_s_); }
  /// From a second to a quarter of an hour; one in eight has no end.
  Span span() {
    const double from = moment();
    const double takes = scale(1, 900);
    return {from, chance(0.125) ? kForever : from + takes};
  }
  /// One that ends: nobody can tell what a vehicle without its senses does for ever.
  Span passing() {
    const double from = moment();
    return {from, from + scale(4, 1200)};
  }
  LineWay sbcWay() { return chance(0.5) ? LineWay::ToSbc : LineWay::FromSbc; }
  LineWay anyWay() { return static_cast<LineWay>(below(4)); }
  LineFault on(LineWay way) {
    LineFault fault;
    fault.way = way;
    fault.when = span();
    return fault;
  }
  void both(LineWay there, LineWay back, LineFault fault, Faults& faults) {
    for (const LineWay way : {there, back}) {
      fault.way = way;
      faults.lines.push_back(fault);
    }
  }
  void addLine(FaultKind kind, Faults& faults);
  void addSensor(FaultKind kind, Faults& faults);
  void addClock(Faults& faults);
  void addSeveral(Faults& faults);

  Noise noise_;
  double flight_s_;
};

void Draw::addLine(FaultKind kind, Faults& faults) {
  LineFault fault = on(anyWay());
  switch (kind) {
    case FaultKind::ByteLoss:
      fault.loss = scale(1e-4, 0.3);
      break;
    case FaultKind::BitFlips:
      fault.flips = scale(1e-4, 0.3);
      break;
    case FaultKind::Bursts:
      fault.bursts = scale(1e-5, 0.01);
      fault.burst_bytes = scale(2, 2000);
      break;
    case FaultKind::Delay:
      fault.delay_s = scale(0.05, 20);
      break;
    case FaultKind::DoubledFrames:
      fault.doubled = between(0.05, 1);
      break;
    case FaultKind::HalfOpen:
      fault.way = sbcWay();
      fault.cut = true;
      break;
    case FaultKind::LineCut:
      fault.cut = true;
      both(LineWay::ToSbc, LineWay::FromSbc, fault, faults);
      return;
    case FaultKind::BaudMismatch:
      fault.heard_at_baud = chance(0.5) ? 57600 : 230400;
      both(LineWay::ToSbc, LineWay::FromSbc, fault, faults);
      return;
    default:
      fault.cut = true;
      if (chance(0.5)) {
        both(LineWay::ToFlight, LineWay::FromFlight, fault, faults);
        return;
      }
      fault.way = chance(0.5) ? LineWay::ToFlight : LineWay::FromFlight;
  }
  faults.lines.push_back(fault);
}

void Draw::addSensor(FaultKind kind, Faults& faults) {
  SensorFault fault;
  fault.name = kSensors[below(kSensors.size())];
  fault.when = passing();
  fault.kind = kind == FaultKind::SensorFrozen    ? SensorFault::Kind::Frozen
               : kind == FaultKind::SensorMissing ? SensorFault::Kind::Missing
                                                  : SensorFault::Kind::Value;
  fault.value = kind == FaultKind::SensorNan ? std::nan("") : kNonsense[below(kNonsense.size())];
  faults.sensors.push_back(fault);
}

void Draw::addClock(Faults& faults) {
  const uint32_t count = 1 + below(4);
  for (uint32_t i = 0; i < count; ++i) {
    faults.clock.push_back({moment(), (chance(0.5) ? 1 : -1) * scale(1, 1e6)});
  }
}

void Draw::addSeveral(Faults& faults) {
  const uint32_t count = 2 + below(3);
  for (uint32_t i = 0; i < count; ++i) {
    constexpr auto kFirst = static_cast<uint32_t>(FaultKind::ByteLoss);
    constexpr auto kAfter = static_cast<uint32_t>(FaultKind::Several);
    add(static_cast<FaultKind>(kFirst + below(kAfter - kFirst)), faults);
  }
}

void Draw::add(FaultKind kind, Faults& faults) {
  switch (kind) {
    case FaultKind::None:
      return;
    case FaultKind::Port:
      faults.port.push_back(span());
      return;
    case FaultKind::Power:
      faults.power.push_back(span());
      return;
    case FaultKind::Stuck:
      faults.stuck.push_back(span());
      return;
    case FaultKind::Science: {
      const double from = moment();
      faults.science.push_back({from, from + scale(2, 300)});
      return;
    }
    case FaultKind::FlightAbort:
      faults.aborts.push_back(moment());
      return;
    case FaultKind::Clock:
      addClock(faults);
      return;
    case FaultKind::SensorFrozen:
    case FaultKind::SensorMissing:
    case FaultKind::SensorNan:
    case FaultKind::SensorRange:
      addSensor(kind, faults);
      return;
    case FaultKind::Several:
      addSeveral(faults);
      return;
    default:
      addLine(kind, faults);
  }
}

}  // namespace

const char* nameOf(FaultKind kind) {
  switch (kind) {
#define FAULT_KIND(name, text) \
  case FaultKind::name:        \
    return text;
#include "simulator/campaign/fault_kinds.def"
#undef FAULT_KIND
  }
  return "";
}

Faults drawFaults(FaultKind kind, uint64_t seed, double flight_s) {
  Faults faults;
  Draw(seed, flight_s).add(kind, faults);
  return faults;
}

}  // namespace glider::simulator
